import type { Body } from '../../../dynamics/body.js';
import type { Simulation } from '../../../dynamics/simulation.js';
import { Effect, type Cause, type Numbered } from '../../effect/effect.js';
import type { MovingSurfaces, ToldSurface } from '../moving-surface.js';
import { Volume, type WaterSource } from '../volume.js';
import { WaveSurface, type KeptSurface } from './surface.js';

/** All surfaces of a world that move. */
export class Waves extends Effect implements MovingSurfaces {
  readonly #simulation: Simulation;
  /** Which version of each was told. */
  readonly #told = new WeakMap<WaveSurface, number>();
  readonly #surfaces = new Map<WaterSource, WaveSurface>();

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  of(source: WaterSource): WaveSurface | undefined {
    return this.#surfaces.get(source);
  }

  override need(source: WaterSource, reason: string): void {
    super.need(source, reason);
    this.changed(source);
  }

  override release(node: Cause): void {
    super.release(node);
    this.#surfaces.delete(node as WaterSource);
  }

  override unmade(node: Cause): void {
    for (const surface of this.#surfaces.values()) surface.unmade(node as Body);
    super.unmade(node);
  }

  changed(source: WaterSource): void {
    const volume = new Volume(source);
    const surface = this.of(source);
    if (surface?.fits(volume)) surface.follow(volume);
    else this.#surfaces.set(source, new WaveSurface(volume));
    this.#simulation.bodies.goOn();
  }

  override beforeStep(dt: number): void {
    for (const surface of this.#surfaces.values()) surface.begin(dt);
  }

  override settle(): void {
    for (const surface of this.#surfaces.values()) surface.end();
  }

  override stepOver(): void {
    for (const { asleep } of this.#surfaces.values()) if (!asleep) this.#simulation.bodies.goOn();
  }

  // ---- what is seen -----------------------------------------------------------------------------------------------

  tell(): ToldSurface[] | undefined {
    const told: ToldSurface[] = [];
    for (const [{ id }, surface] of this.#surfaces) {
      const { version, heights } = surface.shown;
      if (this.#told.get(surface) === version) continue;
      this.#told.set(surface, version);
      told.push({ id, version, heights });
    }
    return told.length > 0 ? told : undefined;
  }

  hear(told: readonly ToldSurface[]): void {
    for (const [{ id }, surface] of this.#surfaces) {
      const of = told.find((each) => each.id === id);
      if (of) surface.hear(of);
    }
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  override reset(): void {
    for (const surface of this.#surfaces.values()) surface.reset();
  }

  override save(): [id: number, kept: KeptSurface][] {
    return [...this.#surfaces].map(([{ id }, surface]) => [id, surface.save()]);
  }

  override load(saved: readonly [id: number, kept: KeptSurface][], nodes: Numbered): void {
    const kept = new Map(saved);
    for (const [{ id }, surface] of this.#surfaces) {
      const of = kept.get(id);
      if (of) surface.load(of, nodes);
    }
    this.#simulation.bodies.goOn();
  }
}
