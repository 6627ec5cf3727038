import type { World } from '../../physics-core/index.js';
import type { PhysicsNode } from '../../physics-core/nodes/node/node.js';
import { listenToBullet, type Core } from './core.js';
import { recorder, type Call } from './recorder.js';

type Instrumented = typeof Core;

const box = { geometry: [{ type: 'Box' }] };

/** Two boxes, one above the other and apart, some steps after their start: nothing is made for the first time any more. */
async function twoBoxes(core: Instrumented, hinged: boolean): Promise<Scene> {
  const world = await core.createWorld({ rest: 'never' });
  listenToBullet(world.engine.ammo);
  const upper = world.add('RigidBody', { position: [0, 8, 0], ...box });
  const lower = world.add('RigidBody', { position: [0, 5, 0], ...box });
  const scene = { world, upper, lower, joint: hinged ? addHinge(world, upper, lower) : undefined };
  world.step(3);
  return scene;
}

interface Scene {
  world: World;
  upper: PhysicsNode;
  lower: PhysicsNode;
  joint: PhysicsNode | undefined;
}

const addHinge = (world: World, body1: PhysicsNode, body2: PhysicsNode): PhysicsNode =>
  world.add('SingleAxisHingeJoint', { body1, body2, anchorPoint: [0, 6.5, 0], axis: [0, 0, 1] });

/** What a user does, in a scene of its own. */
export interface Walk {
  says: string;
  /** What of Bullet it is about. */
  reaches: string;
  hinged: boolean;
  go(scene: Scene): void;
}

const heavier = ({ world, lower }: Scene): void => {
  lower.set('mass', 3);
  world.flush();
};

export const walks = {
  massOfFree: {
    says: "set('mass', 3) on a free body, and flush",
    reaches: 'btRigidBody.setMassProps',
    hinged: false,
    go: heavier,
  },
  massOfHinged: {
    says: "set('mass', 3) on a body with a hinge, and flush",
    reaches: 'btRigidBody.setMassProps',
    hinged: true,
    go: heavier,
  },
  step: {
    says: 'one step of two free bodies',
    reaches: 'btDiscreteDynamicsWorld.stepSimulation',
    hinged: false,
    go: ({ world }) => world.step(),
  },
  hinge: {
    says: 'a hinge is added, and flush',
    reaches: 'new JointConstraint',
    hinged: false,
    go({ world, upper, lower }) {
      addHinge(world, upper, lower);
      world.flush();
    },
  },
  angle: {
    says: 'angle of a hinge is read',
    reaches: 'HeapReader.pose',
    hinged: true,
    go: ({ joint }) => void joint!.get('angle'),
  },
} satisfies Record<string, Walk>;

/** The calls of a walk. */
export async function walked(core: Instrumented, { hinged, go }: Walk): Promise<Call[]> {
  const scene = await twoBoxes(core, hinged);
  try {
    return recorder.record(() => go(scene));
  } finally {
    scene.world.destroy();
  }
}
