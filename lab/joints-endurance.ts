import { loadEngine, World, type LevelName } from '../physics-core/inside.js';
import { addBoxChain, boxChain, Snake } from '../test/core/joint-scenes.js';

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

interface Long {
  joints: readonly { gap: number }[];
  link: number;
  /** Before each frame. */
  frame?(): void;
}

const scenes: Record<string, { seconds: number; build(world: World): Long }> = {
  '100 hinged links released level': {
    seconds: 10,
    build: (world) => ({ ...addBoxChain(world, boxChain(100)), link: 0.1 }),
  },
  'scene 4, 500 hinges': {
    seconds: 14,
    build: (world) => {
      const snake = new Snake(world, 500);
      return { joints: snake.joints, link: 0.5, frame: () => snake.grow() };
    },
  },
};

async function endure(scene: string, level: LevelName, on: boolean): Promise<Endurance> {
  const { seconds, build } = scenes[scene]!;
  const world = new World();
  world.add('RigidBodyCollection', { accuracy: level, rest: 'never' });
  const { joints, link, frame } = build(world);
  world.start(await loadEngine());
  world.registry.joints.on = on;
  let [widest, sum] = [0, 0];
  for (let i = 0; i < 60 * seconds; i++) {
    frame?.();
    world.advance(1 / 60);
    const gaps = joints.map((joint) => joint.gap);
    widest = Math.max(widest, Math.max(...gaps) / link);
    sum = Math.max(sum, gaps.reduce((a, b) => a + b) / (link * gaps.length));
  }
  world.destroy();
  return { scene, level, solve: on ? 'on' : 'off', seconds, widest, sum };
}

export async function endurance(): Promise<Endurance[]> {
  const all: Endurance[] = [];
  for (const on of [true, false]) {
    for (const level of ['game', 'standard', 'fine'] as const)
      all.push(await endure('100 hinged links released level', level, on));
    all.push(await endure('scene 4, 500 hinges', 'standard', on));
  }
  return all;
}
