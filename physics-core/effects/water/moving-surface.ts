import type { Body } from '../../dynamics/body.js';
import type { Flat } from '../../shapes/cut/cut.js';
import type { Effect } from '../effect/effect.js';
import type { BodyFrame } from './body-frame.js';
import type { CutBody } from './cut-body.js';
import type { WaterSource } from './volume.js';

/** A surface that moves, as what is pushed by water sees it. */
export interface MovingSurface {
  /** How far above the still water something may be and be in it, metres. */
  readonly crest: number;
  /** Nothing stirs it: it is flat. */
  readonly asleep: boolean;
  /** How far above the still water it is there, metres, by how far that is from the volume's middle along its width and length. */
  heightAt(across: number, along: number): number;
  /** By how much faster the lift of the body that it met last grows as that sinks: its water rises meanwhile. */
  readonly stiffens: number;
  /** m³ of its water that move with what pushes there, all the way down. */
  readonly column: number;
  /** A body is to be pushed by its water. */
  attend(body: Body): void;
  /**
   * The surface under it, of which such a share is in the volume, in the axes of its centre of mass, as it will be with what
   * it displaces; and what the water there adds to the direction of its weight and to its flow.
   */
  meet(cut: CutBody, share: number, frame: BodyFrame, plane: Flat, gravity: Flat, flow: Flat): void;
  /** It displaces so many m³ of this water. */
  displaced(volume: number): void;
  /** Of all water, m³ of which it displaces, it was pushed by so many newtons, world frame: its share of them pushes back. */
  answer(force: Flat, volume: number, dt: number): void;
  readonly shown: ShownSurface;
}

/** A surface as somebody draws it. */
export interface ShownSurface {
  /** Cells along its width and its length, and how long these are, metres. */
  readonly columns: number;
  readonly rows: number;
  readonly width: number;
  readonly length: number;
  /** Above the still water, of the cells' middles, metres: row by row from the volume's least x and z on. */
  readonly heights: Float32Array;
  /** Another number whenever the heights are others. */
  readonly version: number;
}

/** One as another thread is told of it, by the number of its node. */
export type ToldSurface = Pick<ShownSurface, 'heights' | 'version'> & { readonly id: number };

/** All surfaces of a world that move. */
export interface MovingSurfaces extends Effect {
  /** That of a node that needs it. */
  of(source: WaterSource): MovingSurface | undefined;
  /** What is said of a volume is no more what it was. Divided in another way, its surface begins anew. */
  changed(source: WaterSource): void;
  /** What a page is to hear whose steps are taken here: those that have changed since it was told. */
  tell(): ToldSurface[] | undefined;
  /** Its steps are taken elsewhere; what that side told. */
  hear(told: readonly ToldSurface[]): void;
}
