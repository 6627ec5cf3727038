import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { createWorld } from '../../physics-core/index.js';
import { collect, collectYoung } from '../run/collect.js';
import type { Progress } from '../run/progress.js';
import { timeOf } from '../run/time-of.js';
import { estimate } from '../statistics.js';
import { babylonFountain } from './babylon.js';
import { spread, type Pains } from './conditions.js';
import type { NodeRow } from './numbers.js';
import { addFountain, type NodeScene } from './scenes.js';

/** One side under way. */
interface Side {
  name: string;
  step(): void;
  /** How many live. */
  living(): number;
  end(): void;
  /** Seconds of one step. */
  seconds: number;
  /** Milliseconds of every step, by turns. */
  turns: number[][];
}

async function ours(scene: NodeScene, count: number): Promise<Side> {
  const world = await createWorld();
  scene.addBodies?.(world);
  const system = count > 0 ? addFountain(world, scene, count) : undefined;
  return {
    name: system ? 'ours' : 'bodies',
    step: () => void world.step(),
    living: () => Number(system?.get('count') ?? 0),
    end: () => world.destroy(),
    seconds: world.timeStep,
    turns: [],
  };
}

/** What Babylon.js moves particles by; nothing is drawn. */
async function babylon(count: number): Promise<Side> {
  const engine = new NullEngine();
  const system = babylonFountain(new Scene(engine), count, false);
  return {
    name: 'babylon',
    // Without what they are drawn with.
    step: () => system.animate(true),
    living: () => system.particles.length,
    end: () => engine.dispose(),
    seconds: system.updateSpeed,
    turns: [],
  };
}

async function begin(scene: NodeScene, count: number): Promise<Side[]> {
  const sides = [await ours(scene, count)];
  if (scene.addBodies) sides.push(await ours(scene, 0));
  if (scene.inBabylon) sides.push(await babylon(count));
  return sides;
}

function takeTurn({ step, turns }: Side, steps: number): void {
  collectYoung();
  turns.push(Array.from({ length: steps }, () => timeOf(step)));
}

const meansOf = ({ turns }: Side): number[] =>
  turns.map((steps) => steps.reduce((sum, ms) => sum + ms, 0) / steps.length);

/** A scene by all sides that have it, in turns, from when as many live as ever will. */
export async function measureScene(
  scene: NodeScene,
  { count, turns, each }: Pains,
  progress: Progress,
): Promise<NodeRow> {
  const sides = await begin(scene, count);
  for (const { name, step, seconds } of sides) {
    progress(`${scene.name}: ${name} comes to be as it stays`);
    for (let time = 0; time < scene.before + 1; time += seconds) step();
  }
  collect();
  for (let turn = 0; turn < turns; turn++)
    // None is always the first.
    for (const i of sides.keys()) {
      progress(`${scene.name}: turn ${turn + 1} of ${turns}`);
      takeTurn(sides[(i + turn) % sides.length]!, each);
    }
  const row = rowOf(scene, sides);
  for (const side of sides) side.end();
  return row;
}

function rowOf({ id }: NodeScene, sides: readonly Side[]): NodeRow {
  const means = Object.fromEntries(sides.map((side) => [side.name, meansOf(side)]));
  const { ours: own, bodies, babylon: theirs } = means;
  return {
    scene: id,
    living: sides[0]!.living(),
    sides: Object.fromEntries(sides.map(({ name, turns }) => [name, spread(turns.flat())])),
    ...(bodies && { added: spread(own!.map((ms, i) => ms - bodies[i]!)) }),
    ...(theirs && { toBabylon: estimate(own!.map((ms, i) => ms / theirs[i]!)) }),
  };
}
