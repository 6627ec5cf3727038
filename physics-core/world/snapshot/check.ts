import { bytesOf, doublesOf, floatsOf, wordsOf } from '../../base/packed.js';
import { POSE } from '../../dynamics/poses.js';
import { levelNames } from '../../dynamics/levels.js';
import { BOX, STATE } from '../../engine/kept-bodies.js';
import { areContacts } from '../../engine/kept-contacts.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { boxesIn } from './bodies.js';
import { FORMAT, type BodyStates, type NodeState, type Snapshot } from './snapshot.js';

/** What is wrong with what is to be restored, for people; undefined: nothing. Looked at before anything is touched. */
export function faultOf(given: unknown, nodes: Iterable<PhysicsNode>): string | undefined {
  if (!isRecord(given) || typeof given.x3dPhysics !== 'number')
    return 'restore takes what snapshot() gave';
  if (given.x3dPhysics !== FORMAT)
    return `this snapshot is of another version of x3d-physics (it is written in ${given.x3dPhysics}, here ${FORMAT} is read)`;
  const snapshot = given as unknown as Snapshot;
  try {
    if (!isWhole(snapshot)) return 'parts of this snapshot are missing, or are no numbers';
  } catch {
    return 'parts of this snapshot can’t be read';
  }
  return isOf(snapshot, nodes) ? undefined : 'this snapshot is of another scene';
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

function isWhole({
  time,
  taken,
  level,
  origin,
  nodes,
  bodies,
  contacts,
  effects,
  extent,
}: Snapshot) {
  return (
    isNumber(time) &&
    isNumber(taken) &&
    levelNames.includes(level) &&
    (origin === undefined || isSound(origin)) &&
    nodes.every(isNode) &&
    areBodies(bodies) &&
    areContacts(wordsOf(contacts), bodies.ids.length) &&
    isSound(effects) &&
    extentOf(effects) === extent
  );
}

const isNumber = (value: unknown): boolean => Number.isFinite(value);

function isNode({ id, type, start, asked, authored, beforeEvent = [], heard, joint }: NodeState) {
  return (
    isNumber(id) &&
    typeof type === 'string' &&
    [authored, heard].every((names) => names === undefined || Array.isArray(names)) &&
    isSound(start) &&
    isSound(joint) &&
    [...asked, ...beforeEvent].every(([, value]) => isSound(value))
  );
}

function areBodies({ ids, flags, states, boxes, placed, poses, list }: BodyStates): boolean {
  const how = bytesOf(flags);
  const numbers = floatsOf(states);
  const sides = floatsOf(boxes);
  const places = doublesOf(poses);
  return (
    ids.every(isNumber) &&
    how.length === ids.length &&
    numbers.length === STATE * ids.length &&
    sides.length === BOX * boxesIn(how) &&
    numbers.every(Number.isFinite) &&
    sides.every(Number.isFinite) &&
    placed.every(isNumber) &&
    places.length === POSE * placed.length &&
    places.every(Number.isFinite) &&
    (list === 0 || list === 1)
  );
}

/** Whether all numbers in it are numbers: JSON makes null of NaN. */
function isSound(value: unknown): boolean {
  if (typeof value === 'number') return Number.isFinite(value);
  if (Array.isArray(value)) {
    const some = value.some((item) => typeof item === 'number');
    return value.every((item) => (item !== null || !some) && isSound(item));
  }
  return !isRecord(value) || Object.values(value).every(isSound);
}

/** How much there is, down to the letters of packed numbers: what is cut in half has less. */
export function extentOf(value: unknown): number {
  if (value === undefined) return 0;
  if (typeof value === 'string') return value.length;
  if (!isRecord(value)) return 1;
  let sum = 1;
  for (const name in value) sum += extentOf(value[name]);
  return sum;
}

/** Whether its nodes are those of this world, as far as they are still there. */
function isOf({ nodes }: Snapshot, here: Iterable<PhysicsNode>): boolean {
  const types = new Map([...here].map((node) => [node.id, node.type.name]));
  const known = nodes.filter(({ id }) => types.has(id));
  return (
    (known.length > 0 || nodes.length === 0) &&
    known.every(({ id, type }) => types.get(id) === type)
  );
}
