import type { Chain } from '../../../../references/chain.js';
import type { JointNode } from '../../../../physics-core/nodes/joints/joint.js';
import type { BodyNode } from '../../../../physics-core/nodes/body/body.js';
import type { World } from '../../../../physics-core/inside.js';

/** Bodies and joints from the fixed end on, and where the end is that is looked at, from the first joint. */
export interface Jointed {
  bodies: BodyNode[];
  joints: JointNode[];
  end(): number[];
}

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
