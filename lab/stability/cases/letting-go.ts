import type { World } from '../../../physics-core/inside.js';
import type { StabilityCase } from '../case.js';
import {
  addBody,
  addFloor,
  addHinge,
  addJoint,
  box,
  distance,
  greatest,
  height,
  most,
  moved,
  position,
  sphere,
  velocity,
  type Body,
  type Joint,
} from '../scene.js';

// What holds, bears or pulls is another one all at once: what hung or lay there moves as if from that instant.

const G = 9.8;
const WORK = 'its author lets go of it';

/** Frames before it is done, and what the whole takes, seconds. */
const HANGING = 30;
const ASLEEP = 360;
const FALL = 0.5;

interface Loose {
  bodies: Body[];
  /** At that instant. */
  letGo(): void;
  /** Whether all is as it is meant to be before it. */
  ready?(): boolean;
}

/** Once let go, everything falls by g t² / 2. */
const falls = (
  id: string,
  says: string,
  frames: number,
  build: (w: World) => Loose,
): StabilityCase => ({
  id,
  says,
  seconds: frames / 60 + FALL,
  criterion: { what: 'farthest from its free fall', unit: 'm', most: 1e-3 },
  promisedFrom: 'game',
  work: WORK,
  scene(w) {
    const { bodies, letGo, ready } = build(w);
    let from: number[] | undefined;
    let begun = 0;
    let off = 0;
    return {
      before: (_, frame) => {
        if (frame !== frames) return;
        if (ready && !ready()) off = NaN;
        from = bodies.map(height);
        begun = w.time;
        letGo();
      },
      after: () => {
        if (!from) return;
        const fall = (G * (w.time - begun) ** 2) / 2;
        const now = most(bodies.map((body, i) => Math.abs(from![i]! - height(body) - fall)));
        off = Number.isNaN(off) ? NaN : Math.max(off, now);
      },
      measured: () => (from ? off : NaN),
    };
  },
});

/** Three balls below each other on ball joints, the first one on a block. */
function hang(w: World) {
  const block = addBody(w, { fixed: true, geometry: [box(0.2)] });
  const balls: Body[] = [];
  const joints: Joint[] = [];
  for (let i = 0; i < 3; i++) {
    const ball = addBody(w, { position: [0, -(i + 1) / 2, 0], geometry: [sphere(0.1)] });
    const anchorPoint = [0, -(i + 0.5) / 2, 0];
    joints.push(
      addJoint(w, 'BallJoint', { body1: ball, body2: balls[i - 1] ?? block, anchorPoint }),
    );
    balls.push(ball);
  }
  return { block, balls, joints };
}

const hangs = (id: string, says: string, go: (string: ReturnType<typeof hang>) => void) =>
  falls(id, `a string of balls falls at once when ${says}`, HANGING, (w) => {
    const string = hang(w);
    return { bodies: string.balls, letGo: () => go(string) };
  });

/** Of their middle: the mean, as their masses are equal. */
const middle = (bodies: Body[], of: (body: Body) => number[]): number[] =>
  [0, 1, 2].map((axis) => bodies.reduce((sum, body) => sum + of(body)[axis]!, 0) / bodies.length);

/** The middle of what is below the cut goes on as a stone that is thrown. */
const cutInMidSwing: StabilityCase = {
  id: 'cut in mid-swing',
  says: 'a string of balls that swings flies off as it went when its upper joint goes',
  seconds: HANGING / 60 + FALL,
  criterion: { what: 'their middle, farthest from the path of a throw', unit: 'm', most: 1e-3 },
  promisedFrom: 'game',
  work: WORK,
  scene(w) {
    const { balls, joints } = hang(w);
    let thrown: { at: number[]; by: number[]; begun: number } | undefined;
    const path = (seconds: number): number[] =>
      thrown!.at.map(
        (at, axis) => at + thrown!.by[axis]! * seconds - (axis === 1 ? (G * seconds ** 2) / 2 : 0),
      );
    const look = () => {
      if (!thrown) return 0;
      return distance(middle(balls, position), path(w.time - thrown.begun));
    };
    return greatest(look, {
      before: (_, frame) => {
        if (frame === 0) balls[2]!.applyImpulse([3, 0, 1]);
        if (frame !== HANGING) return;
        thrown = { at: middle(balls, position), by: middle(balls, velocity), begun: w.time };
        joints[0]!.remove();
      },
    });
  },
};

/** What hangs pulls at its joints by another weight, and hangs on. */
const heavier: StabilityCase = {
  id: 'mass changes',
  says: 'a string of balls hangs on where it hung when its lowest ball becomes a hundred times as heavy',
  load: { of: 'masses', ratio: 100 },
  seconds: 1,
  criterion: { what: 'farthest from its place', unit: 'm', most: 1e-3 },
  promisedFrom: 'game',
  work: WORK,
  scene(w) {
    const { balls } = hang(w);
    return greatest(moved(balls), {
      before: (_, frame) => {
        if (frame === HANGING) balls[2]!.set('mass', 100);
      },
    });
  },
};

/** The string once it sleeps. */
const cutAsleep: StabilityCase = {
  world: { rest: 'auto' },
  ...falls(
    'cut asleep',
    'a string of balls that hangs asleep falls at once when its upper joint goes',
    ASLEEP,
    (w) => {
      const { balls, joints } = hang(w);
      const ready = (): boolean => balls.every(({ sleeping }) => sleeping);
      return { bodies: balls, letGo: () => joints[0]!.remove(), ready };
    },
  ),
};

/** Ten boxes on a floor, asleep. */
const lies = (
  id: string,
  says: string,
  go: (floor: Body, collidable: ReturnType<World['add']>) => void,
): StabilityCase => ({
  world: { rest: 'auto' },
  ...falls(id, `ten boxes asleep on a floor fall at once when it ${says}`, ASLEEP, (w) => {
    const collidable = w.add('CollidableShape', { shape: [box(60, 1, 60)] });
    const floor = addFloor(w, 0, { geometry: [collidable] });
    const bodies = Array.from({ length: 10 }, (_, i) =>
      addBody(w, { position: [0, 0.5 + i, 0], geometry: [box(1)] }),
    );
    const ready = (): boolean => bodies.every(({ sleeping }) => sleeping);
    return { bodies, letGo: () => go(floor, collidable), ready };
  }),
});

/** Two rods on a hinge, which nothing else holds: their middle moves as if they were one. */
const drifts = (
  id: string,
  says: string,
  change: (w: World, rods: Body[]) => void,
  expected: (seconds: number) => number[],
): StabilityCase => ({
  id,
  says,
  seconds: 0.75,
  criterion: { what: 'farthest from its closed form', unit: 'm', most: 1e-3 },
  promisedFrom: 'game',
  work: 'a load begins',
  world: { gravity: [0, 0, 0] },
  scene(w) {
    const rods = [-0.5, 0.5].map((x) =>
      addBody(w, { position: [x, 0, 0], mass: 1.5, geometry: [box(1, 0.1, 0.1)] }),
    );
    addHinge(w, { body1: rods[0], body2: rods[1], axis: [0, 0, 1] });
    let begun = Infinity;
    let off = 0;
    return {
      before: (_, frame) => {
        if (frame !== 15) return;
        begun = w.time;
        change(w, rods);
      },
      after: () => {
        const [a, b] = rods.map(position);
        const wanted = expected(Math.max(0, w.time - begun));
        const away = wanted.map((value, i) => (a![i]! + b![i]!) / 2 - value);
        off = Math.max(off, Math.hypot(...away));
      },
      measured: () => off,
    };
  },
});

export const lettingGo: StabilityCase[] = [
  hangs('upper joint goes', 'its upper joint goes', ({ joints }) => joints[0]!.remove()),
  hangs('anchor goes', 'the body that it hangs from goes', ({ block }) => block.remove()),
  hangs('anchor loose', 'that body may move, and falls with it', ({ block }) =>
    block.set('fixed', false),
  ),
  cutAsleep,
  cutInMidSwing,
  heavier,
  drifts(
    'gravity begins',
    'two rods on a hinge follow a gravity that begins, from its instant',
    (w) => w.set('gravity', [4, 0, 0]),
    (t) => [2 * t * t, 0, 0],
  ),
  drifts(
    'force begins',
    'two rods on a hinge follow a force that begins on one of them, from its instant',
    (_, rods) => rods[0]!.set('forces', [[0, 0, 6]]),
    (t) => [0, 0, t * t],
  ),
  drifts(
    'kick',
    'two rods on a hinge follow a kick on one of them, from its instant',
    (_, rods) => rods[1]!.applyImpulse([0, 0, 3]),
    (t) => [0, 0, t],
  ),
  lies('floor removed', 'is removed', (floor) => floor.remove()),
  lies('floor disabled', 'is disabled', (floor) => floor.set('enabled', false)),
  lies('floor moved', 'is moved away', (floor) => floor.set('position', [0, -50, 0])),
  lies('floor loose', 'is fixed no more', (floor) => floor.set('fixed', false)),
  lies('floor reshaped', 'is made a small box beside them', (floor) =>
    floor.set('geometry', [{ ...box(0.1), translation: [40, 0, 0] }]),
  ),
  lies('collidable disabled', 'is there but its collidable is disabled', (_, collidable) =>
    collidable.set('enabled', false),
  ),
];
