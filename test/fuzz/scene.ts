import type { World } from '../../physics-core/inside.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { PhysicsNode } from '../../physics-core/nodes/node/node.js';
import type { Snapshot } from '../../physics-core/index.js';
import { Ledger } from './ledger.js';
import type { Act, Heard, NodePlan, Plan } from './plan.js';
import { isRef } from './values.js';

/** What a random scene consists of while it is played. */
export class Scene {
  readonly #world: World;
  readonly #nodes: PhysicsNode[] = [];
  readonly #ledger: Ledger | undefined;
  #snapshots: Snapshot[] = [];

  constructor(world: World, { wild, nodes, edits }: Plan) {
    this.#world = world;
    this.#nodes.push(world.settings);
    this.#ledger = wild ? undefined : new Ledger(world);
    for (const node of nodes) this.#edit({ act: 'add', node });
    for (const { when, act } of edits) if ('event' in when) this.#listen(when, act);
  }

  /** Edits due before this step, and the step. */
  step(number: number, edits: Plan['edits']): void {
    this.edit(number, edits);
    if (this.#ledger) this.#world.flush();
    this.#ledger?.beforeStep();
    this.#world.step();
    this.#ledger?.afterStep();
  }

  /** Edits due before this step. */
  edit(number: number, edits: Plan['edits']): void {
    for (const { when, act } of edits) if ('step' in when && when.step === number) this.#edit(act);
  }

  /** What is wrong now; undefined: nothing. */
  get fault(): string | undefined {
    for (const body of this.#world.bodies) {
      const state = [...body.readPose(new Float64Array(7)), ...this.#world.bodies.velocityOf(body)];
      if (!state.every(Number.isFinite)) return `${body.label} is at ${state.join(' ')}`;
    }
    return this.#softFault() ?? this.#ledger?.fault();
  }

  /** Of ropes, cloths and soft bodies. */
  #softFault(): string | undefined {
    for (const node of this.#world.nodes) {
      const { places } = node as { places?: Float64Array };
      if (places && !places.every(Number.isFinite)) return `${node.label} has points nowhere`;
    }
    return undefined;
  }

  // ---- listeners -----------------------------------------------------------------------------------------------------

  #listen(when: Heard, act: Act): void {
    const { event, of, pick } = when;
    const on = of === 'RigidBodyCollection' ? this.#world : this.#pick([of], pick);
    let left = when.times;
    on?.on(event, () => {
      if (left-- > 0) this.#edit(act);
    });
  }

  // ---- edits ---------------------------------------------------------------------------------------------------------

  #edit(act: Act): void {
    const edit = (): void => this.#do(act);
    if (this.#ledger) this.#ledger.editing(edit);
    else edit();
  }

  #do(act: Act): void {
    const world = this.#world;
    switch (act.act) {
      case 'add':
        this.#add(act.node);
        return;
      case 'set':
        this.#pick([act.of], act.pick)?.set(act.field, this.#value(act.value));
        return;
      case 'unset':
        this.#pick([act.of], act.pick)?.unset(act.field);
        return;
      case 'remove':
        this.#pick([act.of], act.pick)?.remove();
        return;
      case 'world':
        world.set(act.field, act.value);
        return;
      case 'snapshot':
        this.#snapshots = [...this.#snapshots.slice(-2), world.snapshot()];
        return;
      case 'restore':
        if (this.#snapshots.length > 0) world.restore(this.#snapshots[0]!);
        return;
      case 'reset':
        world.reset();
        return;
      case 'step':
        world.step(act.value as number);
        return;
      case 'raycast':
        world.raycast(act.value as never, [0, -5, 0]);
        return;
      default:
        this.#command(act);
    }
  }

  #command(act: Extract<Act, { pick: number }>): void {
    const body = this.#pick(['RigidBody'], act.pick) as BodyNode | undefined;
    if (!body) return;
    switch (act.act) {
      case 'teleport':
        body.teleport(act.position as never, act.orientation as never, act.velocities);
        return;
      case 'drag':
        body.drag(act.value as never)?.move([0, 3, 0]);
        return;
      case 'applyTorque':
        this.#ledger?.push(body, [0, 0, 0], act.value as never, undefined);
        body.applyTorque(act.value as never);
        return;
      case 'applyForce':
        this.#ledger?.push(body, act.value as never, [0, 0, 0], act.at as never);
        body.applyForce(act.value as never, act.at as never);
        return;
      case 'applyImpulse':
        body.applyImpulse(act.value as never, act.at as never);
        return;
      case 'wake':
      case 'sleep':
        body[act.act]();
    }
  }

  #add({ type, fields }: NodePlan): void {
    const given = Object.entries(fields).map(([name, value]) => [name, this.#value(value)]);
    this.#nodes.push(this.#world.add(type, Object.fromEntries(given)));
  }

  /** With the nodes themselves in place of what stands for them. */
  #value(value: unknown): unknown {
    if (Array.isArray(value))
      return value.map((item) => this.#value(item)).filter((item) => item !== undefined);
    return isRef(value) ? (this.#pick(value.of, value.ref) ?? null) : value;
  }

  #pick(of: readonly string[], pick: number): PhysicsNode | undefined {
    const there = this.#nodes.filter((node) => !node.removed && of.includes(node.type.name));
    return there[pick % there.length];
  }
}
