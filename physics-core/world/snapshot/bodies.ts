import type { Pose } from '../../base/math.js';
import { POSE } from '../../dynamics/poses.js';
import { bytesOf, doublesOf, floatsOf, pack, wordsOf } from '../../base/packed.js';
import { BOX, STATE, saveState } from '../../engine/kept-bodies.js';
import type { BodyNode } from '../../nodes/body/body.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { BodySlots } from '../bodies/body-slots.js';
import { dense } from './dense.js';
import { ASLEEP, AWAKE, HOW, NO_LIST, PARKED, type Moment, type Snapshot } from './snapshot.js';

/** A world of bodies. */
export interface BodiesWorld extends NodeWorld {
  readonly bodies: BodySlots;
}

const byId = (bodies: Iterable<BodyNode>): BodyNode[] => [...bodies].sort((a, b) => a.id - b.id);

/** How many of them have boxes. */
export const boxesIn = (flags: Uint8Array): number =>
  flags.filter((flag) => Math.floor(flag / HOW) !== NO_LIST).length;

/** Bodies and what touches, as they stand in Bullet. */
export function takeBodies(world: BodiesWorld): Moment {
  const { bullet, engine } = world;
  const bodies = byId(world.bodies);
  const states = new Float32Array(bodies.length * STATE);
  const flags = new Uint8Array(bodies.length);
  const boxes = new Float32Array(bodies.length * BOX);
  let used = 0;
  const placed: number[] = [];
  const poses: number[] = [];
  bodies.forEach((body, i) => {
    saveState(engine.ammo, body.pointer, states, i * STATE);
    if (!world.bodies.isAsInBullet(body)) {
      placed.push(body.id);
      poses.push(...world.poses.current.subarray(body.slot * POSE, (body.slot + 1) * POSE));
    }
    const list = bullet.kept?.listOf(body.pointer) ?? -1;
    flags[i] = howIs(body) + HOW * (list < 0 ? NO_LIST : list);
    if (list >= 0) bullet.kept!.saveBox(body.pointer, boxes, BOX * used++);
  });
  return {
    ids: bodies.map(({ id }) => id),
    flags,
    states,
    boxes: boxes.subarray(0, BOX * used),
    placed,
    poses: Float64Array.from(poses),
    contacts: bullet.kept?.saveContacts() ?? new Int32Array(0),
    list: bullet.kept?.list ?? 0,
  };
}

/** `dt`: seconds of a step. */
export const keptMoment = (moment: Moment, dt: number): Snapshot['bodies'] =>
  dense.here
    ? dense.code.pack(moment, dt)
    : (Object.fromEntries(Object.entries(moment).map(asText)) as never);

const asText = ([name, value]: [string, unknown]): [string, unknown] => [
  name,
  ArrayBuffer.isView(value) ? pack(value as Int32Array) : value,
];

export function momentIn({ bodies }: Snapshot): Moment {
  if (typeof bodies === 'string') return dense.code.unpack(bodies);
  return {
    ...bodies,
    flags: bytesOf(bodies.flags),
    states: floatsOf(bodies.states),
    boxes: floatsOf(bodies.boxes),
    poses: doublesOf(bodies.poses),
    contacts: wordsOf(bodies.contacts),
  };
}

const poseAt = (of: Float64Array, at: number): Pose => ({
  p: [of[at]!, of[at + 1]!, of[at + 2]!],
  q: [of[at + 3]!, of[at + 4]!, of[at + 5]!, of[at + 6]!],
});

function howIs(body: BodyNode): number {
  if (body.presence.parked) return PARKED;
  return body.sleeping ? ASLEEP : AWAKE;
}

/** Puts bodies there and has them touch as they did. `slept`: those that were asleep before, and are not said to fall asleep. */
export function loadBodies(world: BodiesWorld, kept: Moment, slept?: ReadonlySet<BodyNode>): void {
  const { bullet } = world;
  const { ids, flags, states, boxes, poses, contacts, list: current } = kept;
  const placed = new Map(kept.placed.map((id, i) => [id, poseAt(poses, i * POSE)]));
  const found = new Map([...world.bodies].map((body) => [body.id, body]));
  for (const body of found.values()) if (body.kinematic) body.standStill();
  const awaited: { body: BodyNode; list: number; box: number }[] = [];
  let box = 0;
  ids.forEach((id, i) => {
    const list = Math.floor(flags[i]! / HOW);
    const body = found.get(id);
    if (body) {
      world.bodies.load(body, states, i * STATE, placed.get(id));
      if (flags[i]! % HOW === PARKED) body.presence.park();
      else if (list !== NO_LIST && body.active) awaited.push({ body, list, box });
    }
    if (list !== NO_LIST) box += BOX;
  });
  bullet.kept?.goBack(
    awaited.map(({ body }) => body),
    awaited.map(({ list }) => list),
    { boxes, at: awaited.map((each) => each.box), contacts, list: current },
  );
  ids.forEach((id, i) => {
    const body = found.get(id);
    if (!body?.active || !body.movable) return;
    if (flags[i]! % HOW !== ASLEEP) body.wake();
    else if (slept?.has(body)) world.bodies.restoreSleep(body);
    else body.sleep();
  });
}
