import { levels, loadEngine, World } from '../physics-core/inside.js';
import { chainEnd } from '../test/core/chain-reference.js';
import { addBallChain, addBoxChain, ballChain, boxChain } from '../test/core/joint-scenes.js';
import { rawChain, type Stepped } from './joints-raw.js';

/** Seconds of each run: chains are chaotic, and later the reference itself means little. */
const SECONDS = 1;

/** Runs of each dot; the fastest counts. */
const RUNS = 5;

export type Way = 'with the joint solve' | "Bullet's iterations alone" | 'raw Ammo';

/** One dot of a chart. */
export interface Dot {
  chain: string;
  way: Way;
  /** A level, or a step. */
  label: string;
  /** Milliseconds of work per simulated second. */
  ms: number;
  /** Greatest distance of the end from the truth, metres. */
  error: number;
}

const chains = [
  { name: '1:20', chain: ballChain(20), add: addBallChain, perFrame: 64 },
  { name: '1:1000', chain: ballChain(1000), add: addBallChain, perFrame: 64 },
  { name: '100 links', chain: boxChain(100), add: addBoxChain, perFrame: 16 },
];
type Case = (typeof chains)[number];

async function ours({ chain, add }: Case, accuracy: string, on: boolean): Promise<Stepped> {
  const world = new World();
  world.add('RigidBodyCollection', { accuracy, rest: 'never', gravity: [0, -chain.gravity, 0] });
  const { end } = add(world, chain);
  world.start(await loadEngine());
  world.registry.joints.on = on;
  return {
    timeStep: world.timeStep,
    step: () => void world.step(),
    end,
    destroy: () => world.destroy(),
  };
}

/** Error and work of one run. */
function run(stepped: Stepped, truth: number[][]): { error: number; ms: number } {
  let [error, ms] = [0, 0];
  const steps = Math.round(1 / 60 / stepped.timeStep);
  for (const expected of truth.slice(1)) {
    const start = performance.now();
    for (let i = 0; i < steps; i++) stepped.step();
    ms += performance.now() - start;
    error = Math.max(error, Math.hypot(...stepped.end().map((x, i) => x - expected[i]!)));
  }
  stepped.destroy();
  return { error, ms: ms / SECONDS };
}

interface Candidate {
  way: Way;
  label: string;
  make(): Promise<Stepped>;
}

function candidates(which: Case): Candidate[] {
  return [
    ...levels.flatMap(({ name }): Candidate[] => [
      { way: 'with the joint solve', label: name, make: () => ours(which, name, true) },
      { way: "Bullet's iterations alone", label: name, make: () => ours(which, name, false) },
    ]),
    ...[60, 120, 240, 480, 960].map((rate): Candidate => ({
      way: 'raw Ammo',
      label: `1/${rate}`,
      make: () => rawChain(which.chain, 1 / rate),
    })),
  ];
}

/** All dots of a chain; runs of the candidates take turns, so that the machine's mood hits all alike. */
async function dotsOf(which: Case): Promise<Dot[]> {
  const truth = chainEnd(which.chain, SECONDS, which.perFrame);
  const dots = candidates(which).map((candidate) => ({ candidate, ms: Infinity, error: 0 }));
  for (let i = 0; i <= RUNS; i++) {
    for (const dot of dots) {
      const { ms, error } = run(await dot.candidate.make(), truth);
      dot.error = error;
      // The first run warms the compiler up.
      if (i > 0) dot.ms = Math.min(dot.ms, ms);
    }
  }
  return dots.map(({ candidate: { way, label }, ms, error }) => ({
    chain: which.name,
    way,
    label,
    ms,
    error,
  }));
}

export async function errorsAgainstTime(): Promise<Dot[]> {
  const all: Dot[] = [];
  for (const which of chains) all.push(...(await dotsOf(which)));
  return all;
}
