import type { World } from '../../physics-core/inside.js';
import { bulletAlone, leaveJointsToBullet } from '../engines/ours.js';
import { median } from '../run/median.js';
import { started, type Scene } from '../scenes.js';
import { scenes } from './scenes.js';

/** Steps that one world takes before the next has its turn, and turns of each. */
const TURN = 10;
const TURNS = 20;

/** What a step costs: milliseconds, medians over the turns. */
export interface ContactCost {
  scene: string;
  bodies: number;
  contacts: number;
  /** Ours. */
  solve: number;
  /** Ours where an author sets `iterations`: contacts are left to Bullet's. */
  iterated: number;
  /** Bullet's own, through none of our code. */
  bullet: number;
  /** Ours and Bullet's own, of the same turn. */
  ratio: number;
  /** Ours with the solve and without, of the same turn. */
  more: number;
}

/** Milliseconds at work so far, not by the clock: what else the machine does is not to count. */
function worked(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** Milliseconds of one step. */
function timeOf(step: () => void): number {
  const start = worked();
  for (let i = 0; i < TURN; i++) step();
  return (worked() - start) / TURN;
}

const BY_ITERATIONS = { iterations: 10 };

/** The same scene three times, stepped in turns. */
async function worldsOf(scene: Scene): Promise<[World, World, World]> {
  const raw = await started({ ...scene, fields: BY_ITERATIONS });
  leaveJointsToBullet(raw);
  return [await started(scene), await started({ ...scene, fields: BY_ITERATIONS }), raw];
}

export async function costOf(scene: Scene): Promise<ContactCost> {
  const worlds = await worldsOf(scene);
  const [ours, iterated, raw] = worlds;
  const bullet = bulletAlone(raw);
  const turns = Array.from({ length: TURNS }, () => {
    const solve = timeOf(() => ours.step());
    const without = timeOf(() => iterated.step());
    const alone = timeOf(bullet);
    return { solve, without, alone };
  });
  const { bodies, contacts } = ours.stats;
  for (const world of worlds) world.destroy();
  return {
    scene: scene.name,
    bodies,
    contacts,
    solve: median(turns.map(({ solve }) => solve)),
    iterated: median(turns.map(({ without }) => without)),
    bullet: median(turns.map(({ alone }) => alone)),
    ratio: median(turns.map(({ solve, alone }) => solve / alone)),
    more: median(turns.map(({ solve, without }) => solve / without)),
  };
}

export async function costs(): Promise<ContactCost[]> {
  const all: ContactCost[] = [];
  // The compiler's warm-up.
  await costOf(scenes[1]!);
  for (const scene of scenes) {
    process.stderr.write(`\r\x1b[K${scene.name}`);
    all.push(await costOf(scene));
  }
  process.stderr.write('\r\x1b[K');
  return all;
}
