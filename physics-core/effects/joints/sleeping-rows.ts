import type { Joint } from '../../dynamics/joint.js';
import type { BulletTargets } from './bullet-targets.js';
import type { Component, Forest } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';

/**
 * Bullet's own rows of joints have nothing to do until something touches their bodies, so until then they are let go: that
 * saves two thirds of what Bullet takes for a joint (measured). The joint itself stays, and with it Bullet's islands. Contacts
 * are seen between Bullet's search for them and its solver: the first touch finds the rows on.
 */
export class SleepingRows {
  readonly #bodies: JointedBodies;
  readonly #targets: BulletTargets;
  #joints: readonly Joint[] = [];
  /** By pointer of a body. */
  readonly #partOf = new Map<number, Component>();
  /** Those that may be let go at all: a row that Bullet does not correct can't be told where to stand. */
  readonly #able = new Set<Component>();
  /** Those whose rows are let go, or may be since before joints were numbered anew. */
  readonly #letGo = new Set<Component>();
  #dt = 0;

  constructor(bodies: JointedBodies, targets: BulletTargets) {
    this.#bodies = bodies;
    this.#targets = targets;
  }

  take(joints: readonly Joint[], { components }: Forest): void {
    this.#joints = joints;
    this.#partOf.clear();
    this.#able.clear();
    this.#letGo.clear();
    for (const component of components) {
      this.#letGo.add(component);
      if (this.#corrects(component)) this.#able.add(component);
      for (const i of component.bodies)
        this.#partOf.set(this.#bodies.bodies[i]!.pointer, component);
    }
  }

  #corrects({ joints }: Component): boolean {
    for (const k of joints) {
      const { lockedRows, corrections } = this.#joints[k]!;
      if (lockedRows.some((row) => corrections[row]!.erp === 0)) return false;
    }
    return true;
  }

  /** Whether some rows are let go: contacts must then be seen. */
  get waits(): boolean {
    return this.#letGo.size > 0;
  }

  /** A component is solved: its rows are let go, or told what was found. */
  solved(component: Component, dt: number): void {
    this.#dt = dt;
    if (!this.letGo(component)) this.#tell(component);
  }

  /** What Bullet would do to it is of no account. False: some of its rows can't be let go. */
  letGo(component: Component): boolean {
    const able = this.#able.has(component) && this.#bodies.awake(component);
    if (able) this.#release(component);
    return able;
  }

  #release(component: Component): void {
    this.#letGo.add(component);
    for (const k of component.joints) {
      const { constraint, lockedRows } = this.#joints[k]!;
      constraint!.release(lockedRows);
    }
  }

  #tell(component: Component): void {
    this.#letGo.delete(component);
    for (const k of component.joints) this.#targets.tell(k, this.#joints[k]!, this.#dt);
  }

  /** For a step: what is past a stop is not to be pushed back by Bullet, with a speed that stays. */
  releaseStops(component: Component): void {
    for (const k of component.joints) {
      const { constraint, stops } = this.#joints[k]!;
      if (stops.length > 0) constraint!.releaseStops(stops.map(({ row }) => row));
    }
  }

  /** It is not solved in this step: what was let go holds again. */
  hold(component: Component): void {
    if (this.#letGo.has(component)) this.reset(component);
  }

  /** Bullet's own rows stand where their limits are. */
  reset(component: Component): void {
    this.#letGo.delete(component);
    for (const k of component.joints) this.#joints[k]!.resetTargets();
  }

  /** Something touches a body, by its pointer. */
  touch(pointer: number): void {
    if (this.#letGo.size === 0) return;
    const component = this.#partOf.get(pointer);
    if (component && this.#letGo.has(component)) this.#tell(component);
  }
}
