import type { BoundedRows } from './bounded-rows.js';
import { Closing } from '../../solver/joints/closing.js';
import type { Component } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { LockedRows } from './locked-rows.js';
import type { PointConstraints } from './point-constraints.js';
import type { PostStabilization } from './post-stabilization.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** What it works with. */
interface Parts {
  system: RowSystem;
  bodies: JointedBodies;
  stabilization: PostStabilization;
  pins: PointConstraints;
  rows: LockedRows;
  bounded: BoundedRows;
}

/** Brings joints together after a step, by moving bodies and not by giving them speed. */
export class JointClosing {
  readonly #parts: Parts;
  readonly #rounds = new Closing();

  constructor(parts: Parts) {
    this.#parts = parts;
  }

  /** The joint that was open farthest when last looked at. */
  widest = -1;

  /** Moves the bodies of a component to where its joints are whole, but for errors smaller than `least`. Returns what is left. */
  close(component: Component, dt: number, least: number): number {
    const { stabilization } = this.#parts;
    const rounds = this.#rounds;
    rounds.begin(component.loops.length > 0);
    while (rounds.goesOn(this.#fill(component, dt), least)) {
      if (rounds.better) stabilization.save(component);
      else {
        stabilization.restore(component);
        this.#fill(component, dt);
      }
      stabilization.clearMomentum(component);
      if (!this.#solve(component)) return rounds.left;
      stabilization.move(component);
    }
    if (!rounds.better) stabilization.restore(component);
    return rounds.left;
  }

  #solve(component: Component): boolean {
    const { system, bodies } = this.#parts;
    system.give = this.#rounds.give;
    const solved = system.solve(component) && bodies.sane(component);
    system.give = 0;
    return solved;
  }

  /** For a solution in ways instead of velocities. Returns the worst error of a joint. */
  #fill(component: Component, dt: number): number {
    const { bodies, system, pins, rows, bounded } = this.#parts;
    let worst = 0;
    const note = (k: number, error: number): void => {
      if (error <= worst) return;
      worst = error;
      this.widest = k;
    };
    bodies.readInertia(component, dt);
    system.resisting.clear();
    for (const k of component.pins) {
      note(k, pins.fill(k));
      pins.setWholeTargets(k);
    }
    for (const k of component.rows) {
      note(k, Math.max(rows.fill(k, dt), bounded.fill(k, dt)));
      rows.setWholeTargets(k);
      bounded.setWholeTargets(k);
    }
    return worst;
  }
}
