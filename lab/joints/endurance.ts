import { loadEngine } from '../../physics-core/create.js';
import { World, type LevelName } from '../../physics-core/inside.js';
import { Snake } from '../../references/snake.js';
import { caseOf } from '../cases/index.js';
import { iterated, leaveJointsToBullet, ours } from '../engines/ours.js';
import { gapsIn } from '../run/gap.js';

/** Gaps of long chains at their worst moment. */
export interface Endurance {
  scene: string;
  level: LevelName;
  solve: 'on' | 'off';
  seconds: number;
  /** The widest gap, and the sum of all, as shares of a link and of the whole chain. */
  widest: number;
  sum: number;
}

/** A long chain in motion. */
interface Long {
  /** By 1/60 s. */
  advance(): void;
  gaps(): number[];
  destroy(): void;
}

interface LongScene {
  name: string;
  seconds: number;
  /** Metres from joint to joint. */
  link: number;
  make(level: LevelName, solve: boolean): Promise<Long>;
}

const links: LongScene = {
  name: '100 hinged links released level',
  seconds: 10,
  link: 0.1,
  async make(level, solve) {
    const { scene } = caseOf('chain-100-links');
    const engine = solve ? ours : iterated;
    const setting = engine.settings.find((one) => one.level === level)!;
    const running = await engine.make(scene, setting);
    const steps = Math.round(1 / 60 / running.timeStep);
    const gaps = gapsIn(scene);
    return {
      advance: () => {
        for (let i = 0; i < steps; i++) running.step();
      },
      gaps: () => gaps(running),
      destroy: () => running.destroy(),
    };
  },
};

const scene4: LongScene = {
  name: 'scene 4, 500 hinges',
  seconds: 14,
  link: 0.5,
  async make(accuracy, solve) {
    const world = new World();
    world.add('RigidBodyCollection', { accuracy, rest: 'never' });
    if (!solve) leaveJointsToBullet(world);
    const snake = new Snake(world, 500);
    world.start(await loadEngine());
    return {
      advance: () => {
        snake.grow();
        world.advance(1 / 60);
      },
      gaps: () => snake.joints.map(({ gap }) => gap),
      destroy: () => world.destroy(),
    };
  },
};

async function endure(scene: LongScene, level: LevelName, solve: boolean): Promise<Endurance> {
  const { name, seconds, link, make } = scene;
  const long = await make(level, solve);
  let [widest, sum] = [0, 0];
  for (let i = 0; i < 60 * seconds; i++) {
    long.advance();
    const gaps = long.gaps();
    widest = Math.max(widest, Math.max(...gaps) / link);
    sum = Math.max(sum, gaps.reduce((a, b) => a + b) / (link * gaps.length));
  }
  long.destroy();
  return { scene: name, level, solve: solve ? 'on' : 'off', seconds, widest, sum };
}

export async function endurance(): Promise<Endurance[]> {
  const all: Endurance[] = [];
  for (const solve of [true, false]) {
    for (const level of ['game', 'standard', 'fine'] as const)
      all.push(await endure(links, level, solve));
    all.push(await endure(scene4, 'standard', solve));
  }
  return all;
}
