import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { drags } from './effects.js';
import type { DragEnd } from './hold.js';
import type { Grabbed, SoftWorld } from './soft.js';
import { SoftDrag, type KeptSoftDrag, type SoftGrip } from './soft-drag.js';

/** All hands on the ropes of a world, or on its cloth and soft bodies. */
export class SoftHands {
  readonly #simulation: Simulation;
  readonly #world: SoftWorld;
  readonly #drags = new Set<SoftDrag>();
  /** What held them when the snapshot was taken that is restored, and the step that this was before. */
  #letGo: { step: number; drags: KeptSoftDrag[] } = { step: -1, drags: [] };

  constructor(simulation: Simulation, world: SoftWorld) {
    this.#simulation = simulation;
    this.#world = world;
  }

  /** Undefined where there is nothing that could go along. */
  grab(
    node: Grabbed,
    grip: SoftGrip | undefined,
    point: Vec3,
    onend: (reason: DragEnd) => void,
  ): SoftDrag | undefined {
    const points = this.#world.pointsOf(node);
    if (!points || !grip || !node.settings.enabled) return undefined;
    const drag = new SoftDrag(this, this.#simulation, [node, points], grip, point, onend);
    const before = this.#takeLetGo(node);
    if (before) drag.goOn(before);
    this.#drags.add(drag);
    this.#world.keepAwake(node);
    return drag;
  }

  /** Whether a drag still acts. */
  holds({ body, of }: SoftDrag): boolean {
    return body.settings.enabled && this.#world.pointsOf(body) === of;
  }

  end(drag: SoftDrag, reason: DragEnd): void {
    if (!this.#drags.delete(drag)) return;
    this.#world.keepAwake(drag.body);
    drag.over(reason);
  }

  /** All hands off one of them. */
  letGo(node: object, reason: DragEnd): void {
    for (const drag of [...this.#drags]) if (drag.body === node) this.end(drag, reason);
  }

  // ---- a step ---------------------------------------------------------------------------------------------------------

  /** Before a step: what is held does not rest. */
  wake(): void {
    for (const drag of this.#drags)
      if (this.holds(drag)) this.#world.keepAwake(drag.body);
      else this.end(drag, 'disabled');
  }

  /** Hands make their step, of `dt` seconds. */
  begin(dt: number): void {
    for (const drag of this.#drags) {
      let mass = drags.code.massOf(this.#world.tiedTo(drag.body));
      for (const each of drag.of.masses) mass += each;
      drag.begin(mass, dt);
    }
  }

  get any(): boolean {
    return this.#drags.size > 0;
  }

  /** Those on one of them. */
  *on(node: object): Generator<SoftDrag> {
    for (const drag of this.#drags) if (drag.body === node) yield drag;
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  save(): KeptSoftDrag[] | undefined {
    return this.#drags.size > 0 ? [...this.#drags].map((drag) => drag.save()) : undefined;
  }

  /** Hands don't come back by themselves; who takes hold again before the next step holds as it was held. */
  load(kept: readonly KeptSoftDrag[]): void {
    this.#letGo = { step: this.#simulation.stepsTaken, drags: [...kept] };
  }

  #takeLetGo({ id }: Grabbed): KeptSoftDrag | undefined {
    const { step, drags } = this.#letGo;
    const at =
      step === this.#simulation.stepsTaken ? drags.findIndex((drag) => drag.id === id) : -1;
    return at < 0 ? undefined : drags.splice(at, 1)[0];
  }

  /** The world begins anew, goes back or ends. */
  reset(reason: DragEnd): void {
    this.#letGo = { step: -1, drags: [] };
    for (const drag of [...this.#drags]) this.end(drag, reason);
  }
}
