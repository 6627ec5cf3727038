import type { Simulation } from '../../dynamics/simulation.js';
import { isAwake } from '../../engine/body-heap.js';
import { bodyAAt, bodyBAt, pointAt, pointCountAt } from '../../engine/manifold.js';
import { contactSurface } from '../contacts/effects.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import type { CoupledJoints } from './coupled-joints.js';
import type { Part } from '../../solver/part.js';
import type { ContactPort, ContactStep } from './read-contact.js';
import type { TouchingBodies } from './touching-bodies.js';
import type { TurningCorners } from './turning-corners.js';

const NONE: ReadonlySet<number> = new Set();

/** Reads what a part consists of: bodies, contacts, rows of joints. */
export class PartReader {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bodies: TouchingBodies;
  readonly #port: ContactPort;
  readonly #joints: CoupledJoints;
  readonly #corners: TurningCorners;
  readonly #step: ContactStep = {
    dt: 0,
    slop: 0,
    swept: false,
    rough: false,
    written: NONE,
  };
  /** Points that are left to Bullet. */
  #special: ReadonlySet<number> = NONE;

  constructor(
    simulation: Simulation,
    effects: Effects,
    bodies: TouchingBodies,
    port: ContactPort,
    joints: CoupledJoints,
    corners: TurningCorners,
  ) {
    this.#simulation = simulation;
    this.#effects = effects;
    this.#bodies = bodies;
    this.#port = port;
    this.#joints = joints;
    this.#corners = corners;
  }

  /** A step of `dt` seconds. */
  begin(dt: number): void {
    const surface = this.#effects.caused(contactSurface);
    this.#step.dt = dt;
    this.#step.slop = this.#simulation.bullet.settings.linearSlop;
    this.#step.written = surface?.written ?? NONE;
    this.#special = surface?.special ?? NONE;
    this.#joints.begin();
  }

  /** False: there is something that only Bullet can do. `swept`: its contacts are gone over one at a time. */
  read(part: Part, swept: boolean): boolean {
    const { ammo } = this.#simulation.engine;
    for (const body of part.bodies)
      // What is woken by the first touch has contacts that nobody looked at in this step.
      if (!isAwake(ammo, this.#bodies.pointers[body]!) || !this.#bodies.read(body, this.#step.dt))
        return false;
    if (!this.#readJoints(part)) return false;
    part.jointed = part.rows.length > 0;
    this.#step.swept = swept && !part.jointed;
    this.#step.rough = part.rough;
    for (const manifold of part.manifolds) if (!this.#readContacts(manifold, part)) return false;
    return part.contacts.length > 0;
  }

  #readContacts(manifold: number, { inHeap, contacts: into }: Part): boolean {
    const { ammo } = this.#simulation.engine;
    const a = bodyAAt(ammo, manifold);
    const b = bodyBAt(ammo, manifold);
    const count = pointCountAt(ammo, manifold);
    const p = this.#bodies.numberOf(a);
    const q = this.#bodies.numberOf(b);
    const first = into.length;
    for (let i = 0; i < count; i++) {
      const point = pointAt(manifold, i);
      if (this.#special.has(point)) return false;
      const contact = this.#port.read(point, a, b, p, q, this.#step);
      if (contact >= 0) into.push(contact);
    }
    // What lies in a heap turns about one edge only for a moment: all that counts there is that it comes to rest.
    if (inHeap) this.#corners.leave(into, first);
    else this.#corners.read(into, first, a, b, this.#step.dt);
    return true;
  }

  #readJoints(part: Part): boolean {
    const joints = this.#effects.caused(jointSolve);
    if (!joints) return true;
    for (const i of part.bodies) {
      const body = this.#simulation.bodyAt(this.#bodies.pointers[i]!)!;
      for (const joint of body.joints) {
        // Each once, by the first of its bodies that moves.
        if (!joint.attached || (joint.body1?.movable ? joint.body1 !== body : false)) continue;
        if (joint.lockedRows.length === 0) continue;
        if (!joints.solvedWith(body)) return false;
        if (!this.#joints.add(joint, joints, part)) return false;
      }
    }
    return true;
  }
}
