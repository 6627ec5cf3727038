import { bytesOf, doublesOf, floatsOf, wordsOf } from '../../base/packed.js';
import { POSE } from '../../dynamics/poses.js';
import { levelNames } from '../../dynamics/levels.js';
import { BOX, STATE } from '../../engine/kept-bodies.js';
import type { KeptWorld } from '../../engine/kept-world.js';
import { MOST_PARTS } from '../../solver/tolerances.js';
import { boxesIn } from './bodies.js';
import { FORMAT, type BodyStates, type Snapshot } from './snapshot.js';

/** A node of the world, as far as it is to be known again. */
interface Known {
  readonly id: number;
  readonly type: { readonly name: string };
}

/** What is wrong with what is to be restored, for people; undefined: nothing. Looked at before anything is touched. */
export function faultOf(
  given: unknown,
  nodes: Iterable<Known>,
  kept: KeptWorld | undefined,
): string | undefined {
  if (!isRecord(given) || typeof given.x3dPhysics !== 'number')
    return 'restore takes what snapshot() gave';
  if (given.x3dPhysics !== FORMAT)
    return `this snapshot is of another version of x3d-physics (it is written in ${given.x3dPhysics}, here ${FORMAT} is read)`;
  const snapshot = given as unknown as Snapshot;
  try {
    if (!isWhole(snapshot, kept)) return 'parts of this snapshot are missing, or are no numbers';
  } catch {
    return 'parts of this snapshot can’t be read';
  }
  return isOf(snapshot, nodes) ? undefined : 'this snapshot is of another scene';
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

/** JSON makes null of what is no number, and what is cut in half has less. */
function isWhole(snapshot: Snapshot, kept: KeptWorld | undefined): boolean {
  const { level, parts, bodies, contacts, extent } = snapshot;
  return (
    extentOf(snapshot) === extent &&
    isSound(snapshot) &&
    levelNames.includes(level) &&
    parts >= 1 &&
    parts <= MOST_PARTS &&
    areBodies(bodies) &&
    (kept?.areContacts(wordsOf(contacts), bodies.ids.length) ?? true)
  );
}

function areBodies({ ids, flags, states, boxes, placed, poses, list }: BodyStates): boolean {
  const how = bytesOf(flags);
  const numbers = floatsOf(states);
  const sides = floatsOf(boxes);
  const places = doublesOf(poses);
  return (
    how.length === ids.length &&
    numbers.length === STATE * ids.length &&
    sides.length === BOX * boxesIn(how) &&
    numbers.every(Number.isFinite) &&
    sides.every(Number.isFinite) &&
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

/** How much there is beside this number, down to the letters of packed numbers. */
export function extentOf(value: unknown): number {
  if (typeof value === 'string') return value.length;
  if (!isRecord(value)) return value === undefined || value === null ? 0 : 1;
  let sum = 1;
  for (const name in value) if (name !== 'extent') sum += extentOf(value[name]);
  return sum;
}

/** Whether its nodes are those of this world, as far as they are still there. */
function isOf({ nodes }: Snapshot, here: Iterable<Known>): boolean {
  const types = new Map([...here].map((node) => [node.id, node.type.name]));
  const known = nodes.filter(({ id }) => types.has(id));
  return (
    (known.length > 0 || nodes.length === 0) &&
    known.every(({ id, type }) => types.get(id) === type)
  );
}
