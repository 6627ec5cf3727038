import type { BoundedRows } from './bounded-rows.js';
import type { Component } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { LockedRows } from './locked-rows.js';
import type { NextPoses } from './next-poses.js';
import type { PointConstraints } from './point-constraints.js';
import { Recent } from '../../solver/joints/recent.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/**
 * Rounds, at most, in which the rates asked for are corrected by how far the step would miss. Each gains two digits at the
 * usual speeds, less where a body turns by half a radian in a step.
 */
const ROUNDS = 8;

/** A miss (m, rad) that single precision hardly tells apart ten metres from the origin. */
export const NO_MISS = 1e-6;

/** Misses (m, rad) that a step may leave where its rounds do not find together. */
export const LEFT_OPEN = 1e-5;

/** What it works with. */
interface Parts {
  system: RowSystem;
  bodies: JointedBodies;
  next: NextPoses;
  pins: PointConstraints;
  rows: LockedRows;
  bounded: BoundedRows;
}

/** Finds the velocities that take the bodies of a component, along their round ways, to where its joints are to be. */
export class VelocitySearch {
  readonly #parts: Parts;
  /** Loops that could not be made whole. */
  readonly taut = new Recent();
  /** Components whose round ways could not be met: the step leaves them open. */
  readonly open = new Set<Component>();

  /** Round ways are seen to later in the step. */
  roughly = false;

  constructor(parts: Parts) {
    this.#parts = parts;
  }

  /** `repair` 0: errors are to stay as they are. */
  setTargets(component: Component, dt: number, repair: 0 | 1): void {
    const { pins, rows, bounded } = this.#parts;
    for (const k of component.pins) pins.setTargets(k, dt, repair);
    for (const k of component.rows) {
      rows.setTargets(k, dt, repair);
      bounded.setTargets(k, dt, repair);
    }
  }

  /** With the targets that were set. False: no solution that makes sense. */
  find(component: Component, dt: number, repair: 0 | 1): boolean {
    const { system, bodies } = this.#parts;
    if (!system.solve(component)) return false;
    if (this.roughly) return bodies.sane(component);
    this.correct(component, dt, repair);
    if (this.open.has(component) && !system.firm && component.loops.length > 0) {
      this.taut.begin(component);
      system.firm = true;
      this.#forgetCorrections(component, dt, repair);
      if (!system.solve(component)) return false;
      this.correct(component, dt, repair);
    }
    return bodies.sane(component);
  }

  /** Corrects the rates by how far the step would miss, as long as that helps: where bodies turn too far, energy suffers. */
  correct(component: Component, dt: number, repair: 0 | 1): void {
    let first = Infinity;
    let before = Infinity;
    for (let round = 0; round < ROUNDS; round++) {
      const worst = this.#correctOnce(component, dt, repair);
      if (worst > first) this.#forgetCorrections(component, dt, repair);
      if (worst < LEFT_OPEN) this.open.delete(component);
      else this.open.add(component);
      if (worst < NO_MISS || worst > before) return;
      this.#parts.system.again(component);
      if (round === 0) first = worst;
      before = worst;
    }
  }

  /** Returns by how much the velocities found miss. */
  #correctOnce(component: Component, dt: number, repair: 0 | 1): number {
    const { next, pins, rows } = this.#parts;
    next.predict(component, dt);
    let worst = 0;
    for (const k of component.pins) worst = Math.max(worst, pins.correct(k, dt, repair));
    for (const k of component.rows) worst = Math.max(worst, rows.correct(k, dt, repair));
    return worst;
  }

  #forgetCorrections(component: Component, dt: number, repair: 0 | 1): void {
    const { system, pins, rows } = this.#parts;
    for (const k of component.pins) pins.forgetCorrections(k);
    for (const k of component.rows) rows.forgetCorrections(k);
    this.setTargets(component, dt, repair);
    system.again(component);
  }
}
