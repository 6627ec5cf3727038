import type { Vec3 } from '../../fields/types.js';
import type { Material } from '../../solver/deformables/material.js';
import type { Grabbed } from '../drag/soft.js';

/** What the author of a cloth or a soft body says that is the same for both. */
export interface DeformableSettings {
  readonly enabled: boolean;
  /** FALSE: it goes through everything. */
  readonly touches: boolean;
  /** Half of how thick its surface is, metres: it stays so far from what it touches. */
  readonly radius: number;
  /** Share of its speed that it loses, 1/s. */
  readonly damping: number;
  readonly friction: number;
  /** Points of its surface that stay where they are. */
  readonly fixed: readonly number[];
  /** The air around it and where that goes, m/s; undefined: there is none. */
  readonly wind: Vec3 | undefined;
  readonly selfCollision: boolean;
  /** m/s². */
  readonly gravity: Vec3;
  /** FALSE: it never rests. */
  readonly rests: boolean;
}

/** A node that is a cloth or a soft body. */
export interface DeformableSource extends Grabbed {
  readonly settings: DeformableSettings;
  /** As it is laid. */
  lay(): Material;
  /** What its author says of it now, while it goes on; FALSE: that is another one, which has to be laid. */
  read(material: Material): boolean;
  /** A step can follow this share of its stiffness; 1: all of it. */
  softened(share: number): void;
  /** What does not stretch is stretched by this share of its length. */
  strained(strain: number): void;
  /** Its numbers were lost: it stands where it was. */
  stopped(): void;
  /** It came into water, or out of it. */
  emit(event: string, detail: unknown): void;
  /** After each step of one that moved. */
  stepped(): void;
}
