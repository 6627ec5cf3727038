import { POSE } from '../../dynamics/poses.js';
import { levelNames } from '../../dynamics/levels.js';
import { BOX, STATE } from '../../engine/kept-bodies.js';
import type { KeptWorld } from '../../engine/kept-world.js';
import { MOST_PARTS } from '../../solver/tolerances.js';
import { boxesIn, momentIn } from './bodies.js';
import { alike } from './same.js';
import { statesIn } from './states.js';
import { FORMAT, type Moment, type NodeState, type Snapshot } from './snapshot.js';

/**
 * What is wrong with what is to be restored, for people; undefined: nothing. Looked at before anything is touched. `here`:
 * the nodes that it is to be of; undefined: any.
 */
export function faultOf(
  given: unknown,
  here: Snapshot['nodes'] | undefined,
  kept: KeptWorld | undefined,
): string | undefined {
  if (!isRecord(given) || typeof given.x3dPhysics !== 'number')
    return 'restore takes what snapshot() gave';
  if (given.x3dPhysics !== FORMAT)
    return `this snapshot is of another version (${given.x3dPhysics}, not ${FORMAT})`;
  const snapshot = given as unknown as Snapshot;
  try {
    if (isWhole(snapshot, kept))
      return alike(here, snapshot.nodes) || isOf(statesIn(snapshot), here)
        ? undefined
        : 'this snapshot is of another scene';
  } catch {
    // It can't be read at all.
  }
  return 'parts of this snapshot are missing, or are no numbers';
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

/** JSON makes null of what is no number, and what is cut in half has less. */
function isWhole(snapshot: Snapshot, kept: KeptWorld | undefined): boolean {
  const { level, parts, extent } = snapshot;
  const moment = momentIn(snapshot);
  return (
    extentOf(snapshot) === extent &&
    isSound(snapshot) &&
    levelNames.includes(level) &&
    parts >= 1 &&
    parts <= MOST_PARTS &&
    areBodies(moment) &&
    (kept?.areContacts(moment.contacts, moment.ids.length) ?? true)
  );
}

const areBodies = ({ ids, flags, states, boxes, placed, poses, list }: Moment): boolean =>
  flags.length === ids.length &&
  states.length === STATE * ids.length &&
  boxes.length === BOX * boxesIn(flags) &&
  poses.length === POSE * placed.length &&
  [states, boxes, poses].every((numbers) => numbers.every(Number.isFinite)) &&
  (list === 0 || list === 1);

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
function isOf(states: readonly NodeState[], here: Snapshot['nodes'] | undefined): boolean {
  if (!here) return true;
  const types = new Map(statesIn({ nodes: here }).map(({ id, type }) => [id, type]));
  const known = states.filter(({ id }) => types.has(id));
  return (
    (known.length > 0 || states.length === 0) &&
    known.every(({ id, type }) => types.get(id) === type)
  );
}
