import type { World } from '../../../physics-core/inside.js';

/** What a page with a file in it does. */
export interface Found {
  worlds: number;
  bodies: number;
  joints: number;
  /** Elements of physics that stand in the file. */
  elements: number;
  /** Of each body that moved by more than a millimetre or a hundredth of a radian: its name and metres. */
  moved: [name: string, metres: number][];
  /** Metres that the worst of the joints that hold a point gapes, and the speed of the fastest body at the end, in m/s. */
  gap: number;
  fastest: number;
  /** Metres of height of the lowest body that moves, at the end. */
  lowest: number;
  finite: boolean;
  problems: string[];
}

type Shown = { _x3domNode?: { _childNodes: ({ _xmlNode?: Element } | null)[] } };
type Placed = World['nodes'] extends Iterable<infer Node> ? Node : never;
type Jointed = Placed & { gap: number };

/** Elements of physics, in either spelling. */
const NAMES =
  /^(x3d-)?(rigid-?body(-?collection)?|collidable-?(shape|offset)|collision-?(collection|space|sensor)|contact|.+-?joint)$/;

const wait = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
const length = (...v: number[]) => Math.hypot(...v);

/** The page and, within it, all that Inlines brought. */
const rootsIn = (root: ParentNode): ParentNode[] => [
  root,
  ...[...root.querySelectorAll('inline, Inline')].flatMap((inline) =>
    ((inline as Shown)._x3domNode?._childNodes ?? []).flatMap((child) =>
      child?._xmlNode ? rootsIn(child._xmlNode) : [],
    ),
  ),
];

const elements = (): Element[] =>
  rootsIn(document).flatMap((root) =>
    [...root.querySelectorAll('*')].filter(
      ({ localName }) => NAMES.test(localName.toLowerCase()) && !/^hanim/i.test(localName),
    ),
  );

function worldsNow(): World[] {
  const { worldOf } = (window as never as { X3DPhysics: { worldOf(e: Element): World } })
    .X3DPhysics;
  return [...new Set(elements().flatMap((element) => worldOf(element) ?? []))];
}

/** Milliseconds that a world may take to come, and to be ready. */
const [COMING, READY] = [4000, 15_000];

async function startedWorlds(): Promise<World[]> {
  const end = performance.now() + COMING;
  while (worldsNow().length === 0 && performance.now() < end) await wait(50);
  const ready = worldsNow().map((world) => world.ready.catch(() => undefined));
  await Promise.race([Promise.all(ready), wait(READY)]);
  return worldsNow();
}

const numbers = (node: Placed, field: string) => node.get(field) as number[];
const pose = (body: Placed) => [numbers(body, 'position'), numbers(body, 'orientation')] as const;

function quaternion([x, y, z, a]: number[]): number[] {
  const s = Math.sin(a! / 2) / (length(x!, y!, z!) || 1);
  return [x! * s, y! * s, z! * s, Math.cos(a! / 2)];
}

/** Radians between two orientations. */
function turn(a: number[], b: number[]): number {
  const [p, q] = [quaternion(a), quaternion(b)];
  return 2 * Math.acos(Math.min(1, Math.abs(p.reduce((sum, v, i) => sum + v * q[i]!, 0))));
}

/** Advances all worlds and returns the worst gap on the way. */
async function advance(worlds: World[], joints: Jointed[], seconds: number): Promise<number> {
  let gap = 0;
  for (let time = 0; time < seconds; time += 0.1) {
    for (const world of worlds) world.advance(0.1);
    for (const joint of joints) if (joint.gap > gap) gap = joint.gap;
    await wait(0);
  }
  return gap;
}

/** @param live seconds at the page's own pace before */
async function measure(seconds: number, live: number): Promise<Found> {
  await startedWorlds();
  await wait(live * 1000);
  const worlds = worldsNow();
  const nodes = worlds.flatMap((world) => [...world.nodes]);
  const bodies = nodes.filter(({ type }) => type.name === 'RigidBody');
  const joints = nodes.filter(({ type }) => type.name.endsWith('Joint')) as Jointed[];
  // Sliders and motors leave their bodies a way to go.
  const holding = joints.filter(({ type }) => !/^(Slider|Motor)/.test(type.name));
  for (const world of worlds) world.paused = true;
  if (live === 0) for (const world of worlds) world.reset();
  const before = bodies.map(pose);
  const gap = await advance(worlds, holding, seconds);
  const after = bodies.map(pose);
  const ways = bodies.map((body, k): [Placed, number, number] => {
    const [p0, r0] = before[k]!;
    const [p1, r1] = after[k]!;
    return [body, length(...p1.map((v, i) => v - p0[i]!)), turn(r0, r1)];
  });
  const moved = ways.filter(([, metres, radians]) => metres > 1e-3 || radians > 1e-2);
  const name = (body: Placed) => String((body as { id?: unknown }).id ?? '');
  const speeds = bodies.map((body) => length(...numbers(body, 'linearVelocity')));
  return {
    worlds: worlds.length,
    bodies: bodies.length,
    joints: joints.length,
    elements: elements().length,
    moved: moved.map(([body, metres]) => [name(body), metres]),
    gap,
    fastest: Math.max(0, ...speeds),
    lowest: Math.min(...moved.map(([body]) => numbers(body, 'position')[1]!)),
    finite: after.flat(2).every(Number.isFinite),
    problems: worlds.flatMap(({ problems }) =>
      problems.map(({ code, severity, message }) => `${severity} ${code}: ${message}`),
    ),
  };
}

Object.assign(globalThis, { measureContent: measure });
