import type { Chain } from './chain-reference.js';
import type { JointNode } from '../../physics-core/nodes/joint.js';
import type { BodyNode } from '../../physics-core/nodes/body.js';
import type { World } from '../../physics-core/inside.js';

/** Bodies and joints from the fixed end on, and where the end is that is looked at, from the first joint. */
export interface Jointed {
  bodies: BodyNode[];
  joints: JointNode[];
  end(): number[];
}

const GRAVITY = 9.81;

const place = (body: BodyNode): number[] => body.get('position') as number[];

const connect = (
  world: World,
  type: string,
  bodies: BodyNode[],
  link: number,
  fields = {},
): JointNode[] =>
  bodies.map(
    (body, i) =>
      world.add(type, {
        body1: body,
        ...(i > 0 && { body2: bodies[i - 1] }),
        anchorPoint: [i * link, 0, 0],
        ...fields,
      }) as JointNode,
  );

/** Eight balls of 0.1 m and 0.1 kg, 1 m apart, the last `ratio` times as heavy. */
export function ballChain(ratio: number): Chain {
  const masses = Array.from({ length: 8 }, (_, i) => (i === 7 ? 0.1 * ratio : 0.1));
  const moments = masses.map((m) => 0.4 * m * 0.1 ** 2);
  return { link: 1, centre: 1, masses, moments, gravity: GRAVITY };
}

/** The chain of balls along x; `push`: rad/s at which each link turns to the side. */
export function addBallChain(world: World, { masses }: Chain, push = 0): Jointed {
  const bodies = masses.map(
    (mass, i) =>
      world.add('RigidBody', {
        position: [i + 1, 0, 0],
        mass,
        geometry: [{ type: 'Sphere', radius: 0.1 }],
        linearVelocity: [0, 0, (i + 1) * push],
        angularVelocity: [0, -push, 0],
      }) as BodyNode,
  );
  const joints = connect(world, 'BallJoint', bodies, 1);
  return { bodies, joints, end: () => place(bodies.at(-1)!) };
}

/** `count` boxes of 0.1 kg in a row, hinged end to end, each `link` metres long. */
export function boxChain(count: number, link = 0.1): Chain {
  const masses: number[] = Array<number>(count).fill(0.1);
  const moments = masses.map((m) => (m / 12) * ((0.9 * link) ** 2 + (0.4 * link) ** 2));
  return { link, centre: link / 2, masses, moments, gravity: GRAVITY };
}

export function addBoxChain(world: World, { masses, link }: Chain): Jointed {
  const bodies = masses.map(
    (mass, i) =>
      world.add('RigidBody', {
        position: [(i + 0.5) * link, 0, 0],
        mass,
        geometry: [{ type: 'Box', size: [0.9 * link, 0.4 * link, 0.4 * link] }],
      }) as BodyNode,
  );
  const joints = connect(world, 'SingleAxisHingeJoint', bodies, link, { axis: [0, 0, 1] });
  // Neighbours overlap when they fold.
  world.add('CollisionCollection', { collidables: '*', enabled: false });
  const end = (): number[] => {
    const last = bodies.at(-1)!;
    const [x, y, z, angle] = last.get('orientation') as [number, number, number, number];
    const turn = angle * Math.sign(z || 1);
    void [x, y];
    return place(last).map((p, i) => p + (link / 2) * [Math.cos(turn), Math.sin(turn), 0][i]!);
  };
  return { bodies, joints, end };
}

const LINK = 0.5;

/** Scene 4 of the paper: a chain on the ground that grows by one hinged piece a frame, pushed to and fro. */
export class Snake {
  readonly joints: JointNode[] = [];
  readonly #world: World;
  readonly #pieces: number;
  #last: BodyNode;

  constructor(world: World, pieces: number) {
    this.#world = world;
    this.#pieces = pieces;
    const ground = { type: 'Box', size: [4 * pieces, 1, 4 * pieces] };
    world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
    this.#last = this.#piece({ fixed: true, position: [0, 0.1, 0] });
  }

  #piece(fields: object): BodyNode {
    const geometry = [{ type: 'Box', size: [0.4, 0.2, 0.2] }];
    return this.#world.add('RigidBody', { mass: 0.5, geometry, ...fields }) as BodyNode;
  }

  grow(): void {
    if (this.joints.length >= this.#pieces) return;
    const before = this.#last;
    const [x, y, z] = place(before) as [number, number, number];
    const [, turn, , angle] = before.get('orientation') as [number, number, number, number];
    const heading = angle * Math.sign(turn || 1);
    const [along, across] = [Math.cos(heading), -Math.sin(heading)];
    const at = (way: number, height: number) => [x + way * along, height, z + way * across];
    this.#last = this.#piece({
      position: at(LINK, 0.1),
      orientation: [0, 1, 0, heading],
      linearVelocity: [0, 0, this.joints.length % 2 ? 0.5 : -0.5],
    });
    const bodies = { body1: before, body2: this.#last };
    const fields = { ...bodies, axis: [0, 1, 0], anchorPoint: at(LINK / 2, y) };
    this.joints.push(this.#world.add('SingleAxisHingeJoint', fields) as JointNode);
  }

  get length(): number {
    return LINK * this.joints.length;
  }

  /** The sum of all. */
  get gaps(): number {
    return this.joints.reduce((sum, joint) => sum + joint.gap, 0);
  }
}
