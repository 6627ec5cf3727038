import type { Vec3 } from '../../fields/types.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { isJointed } from '../../dynamics/jointed.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import { Drag, type KeptDrag } from './drag.js';
import { drags } from './effects.js';
import type { DragEnd } from './hold.js';
import { Effect, type Cause, type EffectDescriptor } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import type { Pull } from '../joints/component-solve.js';
import { jointSolve } from '../joints/effects.js';
import { resting } from '../rest/resting.js';

/**
 * Bodies that somebody holds. A drag by a spring is one more force of the body, or one more term of the joint solve where
 * joints hold it: a point-to-point constraint of Bullet's would be solved by iterations, after the joints, and tear
 * them. The other modes make a body immovable while they last. Nothing of Bullet's is made or unmade.
 */
export class Dragging extends Effect implements Pull {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #drags = new Set<Drag>();
  /** What held bodies when the snapshot was taken that is restored, and the step that this was before. */
  #letGo: { step: number; drags: KeptDrag[] } = { step: -1, drags: [] };

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
  }

  /** Undefined where the body can't be dragged so, or by one hand only. */
  grab(body: Body, point: Vec3, onend: (reason: DragEnd) => void): Drag | undefined {
    const alone = body.dragMode !== 'spring';
    if (!body.active || (!alone && !body.movable) || (alone && this.#of(body).length > 0))
      return undefined;
    const drag = new Drag(this, this.#simulation, body, point, onend);
    const before = alone ? undefined : this.#takeLetGo(body);
    if (before) drag.goOn(before);
    this.#drags.add(drag);
    this.need(body, 'drag');
    return drag;
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  /** Springs: what is moved otherwise is carried, or jumps. */
  override save(): KeptDrag[] | undefined {
    const springs = [...this.#drags].filter(({ mode }) => mode === 'spring');
    return springs.length > 0 && drags.here ? springs.map((drag) => drag.save()) : undefined;
  }

  /** Hands don't come back by themselves; who takes hold of the body again before the next step holds it as it was held. */
  override load(kept: readonly KeptDrag[]): void {
    this.#letGo = { step: this.#simulation.stepsTaken, drags: [...kept] };
  }

  #takeLetGo({ id }: Body): KeptDrag | undefined {
    const { step, drags: those } = this.#letGo;
    const at =
      step === this.#simulation.stepsTaken ? those.findIndex((drag) => drag.id === id) : -1;
    return at < 0 ? undefined : those.splice(at, 1)[0];
  }

  /** Whether a drag still acts on its body. */
  holds({ body, mode }: Drag): boolean {
    return body.active && (mode !== 'spring' || body.movable);
  }

  end(drag: Drag, reason: DragEnd): void {
    if (!this.#drags.delete(drag)) return;
    if (this.#of(drag.body).length === 0) this.release(drag.body);
    drag.over(reason);
  }

  /** The world begins anew, or ends. */
  override reset(reason: DragEnd): void {
    this.#letGo = { step: -1, drags: [] };
    for (const drag of [...this.#drags]) this.end(drag, reason);
  }

  /** All hands off a body. */
  letGo(body: Body, reason: DragEnd): void {
    for (const drag of this.#of(body)) this.end(drag, reason);
  }

  /** Its drags go on in another mode: all of them by springs, or the first one alone. */
  modeChanged(body: Body): void {
    const [first, ...others] = this.#of(body);
    first?.engage();
    for (const drag of others)
      if (drag.mode === 'spring') drag.engage();
      else this.end(drag, 'disabled');
  }

  #of(body: Body): Drag[] {
    return this.active ? [...this.#drags].filter((drag) => drag.body === body) : [];
  }

  override unmade(node: Cause): void {
    const body = node as Body;
    this.letGo(body, body.removed ? 'removed' : 'reset');
  }

  /** What is held does not sleep. A joint may have come while it is held: the first one brings the joint solve. */
  override beforeStep(dt: number): void {
    // Taken hold of in this very step: the next one waits for that code.
    if (!drags.here) return;
    this.#effects.caused(jointSolve)?.pulls.add(this);
    for (const drag of this.#drags) {
      if (!this.holds(drag)) this.end(drag, 'disabled');
      else if (drag.mode === 'spring') this.#pull(drag, dt);
    }
  }

  #pull({ body, spring, target }: Drag, dt: number): void {
    if (body.sleeping) body.wake();
    this.#effects.find(resting)?.restart(body.slot);
    spring.slow();
    spring.move(target, dt);
    if (!isJointed(body)) spring.push(dt);
  }

  pullsAt(body: Body): boolean {
    return this.#of(body).some(({ mode }) => mode === 'spring');
  }

  /** A body in the joint solve, where it is number `i`. */
  pullIn(body: Body, system: RowSystem, i: number, dt: number): void {
    for (const { body: held, mode, spring } of this.#drags)
      if (held === body && mode === 'spring') spring.pullIn(system, i, dt);
  }
}

export const dragging: EffectDescriptor<Dragging> = {
  name: 'dragging',
  chunk: drags,
  causes: 'a body that somebody holds',
  load: (simulation, effects) => new Dragging(simulation, effects),
};
