// Whether a scene runs: its world becomes ready, nothing is wrong with it, something moves.
import type { Page as Tab } from 'playwright';
import type { Scene } from './sources.js';

/** Milliseconds until a scene has to be ready and to have moved. */
const LATEST = 30_000;

/** Metres, or as many radians. */
const MOVED = 0.005;

interface State {
  /** Of bodies; of particle systems, how many particles they have and where the oldest one is; and where points of ropes, cloth and soft bodies are. */
  poses: number[][];
  problems: string[];
  /** Of the page and its worlds, for whoever asks why nothing moves. */
  stands: string;
}

/**
 * Runs in the page, of any build of the library: the bodies, particles and soft things of its worlds, and what these complain of. A
 * machine that is busy with other things drops time.
 */
const stateOf = (library: string, begins: boolean): string => `(async () => {
  const { worldOf } = globalThis.X3DPhysics ?? await import('${library}');
  const worlds = new Set();
  for (const element of document.querySelectorAll('x3d *')) {
    const world = worldOf(element);
    if (world) worlds.add(world);
  }
  await Promise.all([...worlds].map(({ ready }) => ready));
  const nodes = [...worlds].flatMap((world) => [...world.nodes]);
  const bodies = nodes.filter((node) => node.applyImpulse);
  const systems = nodes.filter(({ type }) => type.name === 'ParticleSystem');
  const soft = nodes.filter(({ type }) => ['Rope', 'Cloth', 'SoftBody'].includes(type.name));
  // What hardly turns does so about one axis or its opposite.
  const turnOf = ([x, y, z, angle]) => [x * angle, y * angle, z * angle];
  const found = {
    poses: [
      ...bodies.map((node) => [...node.get('position'), ...turnOf(node.get('orientation'))]),
      ...systems.map((node) => [node.get('count'), ...(node.get('positions')[0] ?? [])]),
      ...soft.map((node) => node.get('positions').flat()),
    ],
    problems: [...worlds].flatMap((world) =>
      world.problems.filter(({ code }) => code !== 'lag').map(({ code, message }) => code + ': ' + message)),
    stands: [document.visibilityState, ...[...worlds].map(({ time, stats }) => 'at ' + time + ' s ' + JSON.stringify(stats))].join(', '),
  };
  if (${begins}) for (const world of worlds) world.reset();
  return found;
})()`;

/** `begins`: from there it begins once more, since what falls a little may lie by now. */
const state = (tab: Tab, { library }: Scene, begins = false) =>
  tab.evaluate(stateOf(library, begins)) as Promise<State>;

const wayOf = (before: State, after: State): number =>
  Math.max(
    0,
    ...after.poses.flatMap((pose, i) =>
      pose.map((value, k) => Math.abs(value - (before.poses[i]?.[k] ?? value))),
    ),
  );

async function waitUntilMoved(tab: Tab, scene: Scene, start: State): Promise<State> {
  const end = Date.now() + LATEST;
  for (;;) {
    const now = await state(tab, scene);
    if (wayOf(start, now) > MOVED) return now;
    if (Date.now() > end)
      throw new Error(`nothing moves: ${[now.stands, ...now.problems].join('; ')}`);
    await tab.waitForTimeout(100);
  }
}

/** A piece of markup names what its author has elsewhere. */
const ELSEWHERE = /^(waiting-for-geometry|unknown-reference|not-in-collider|no-body)/;

/** Of a scene that was opened just now. */
export async function broken(tab: Tab, scene: Scene): Promise<string[]> {
  // A story is put into its page when that is there.
  await tab.locator('x3d canvas').first().waitFor({ state: 'attached' });
  const start = await state(tab, scene, true);
  if (start.poses.length === 0) throw new Error('there are no bodies');
  const moved = await waitUntilMoved(tab, scene, start);
  const problems = [...new Set([...start.problems, ...moved.problems])];
  return scene.moves ? problems : problems.filter((problem) => !ELSEWHERE.test(problem));
}
