import type { World } from '../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../physics-core/nodes/node/node.js';
import { listenToBullet, type Core } from './core.js';
import { recorder, type Call } from './recorder.js';

type Instrumented = typeof Core;

const box = { geometry: [{ type: 'Box' }] };

/** A world in which nothing stands yet. */
async function empty(core: Instrumented): Promise<Scene> {
  const world = await core.createWorld({ rest: 'never' });
  listenToBullet(world.engine.ammo);
  return { world };
}

/** Two boxes, one above the other and apart, some steps after their start: nothing is made for the first time any more. */
async function twoBoxes(core: Instrumented): Promise<Boxes> {
  const { world } = await empty(core);
  const boxes = addBoxes(world);
  world.step(3);
  return boxes;
}

/** The same, with a hinge between them. */
async function hinged(core: Instrumented): Promise<Hinged> {
  const { world } = await empty(core);
  const boxes = addBoxes(world);
  const joint = addHinge(world, boxes.upper, boxes.lower);
  world.step(3);
  return { ...boxes, joint };
}

interface Scene {
  world: World;
}

interface Boxes extends Scene {
  upper: PhysicsNode;
  lower: PhysicsNode;
}

interface Hinged extends Boxes {
  joint: PhysicsNode;
}

const addBoxes = (world: World): Boxes => ({
  world,
  upper: world.add('RigidBody', { position: [0, 8, 0], ...box }),
  lower: world.add('RigidBody', { position: [0, 5, 0], ...box }),
});

const addHinge = (world: World, body1: PhysicsNode, body2: PhysicsNode): PhysicsNode =>
  world.add('SingleAxisHingeJoint', { body1, body2, anchorPoint: [0, 6.5, 0], axis: [0, 0, 1] });

/** What a user does, in a scene of its own. */
export interface Walk {
  says: string;
  /** What of Bullet it is about. */
  reaches: string;
  /** Makes the scene; returns it and what is done in it. */
  begin(core: Instrumented): Promise<Scene & { go: () => void }>;
}

const walk = <S extends Scene>(
  says: string,
  reaches: string,
  scene: (core: Instrumented) => Promise<S>,
  go: (scene: S) => void,
): Walk => ({
  says,
  reaches,
  async begin(core) {
    const made = await scene(core);
    return { world: made.world, go: () => go(made) };
  },
});

const heavier = ({ world, lower }: Boxes): void => {
  lower.set('mass', 3);
  world.flush();
};

export const walks = {
  massOfFree: walk(
    "set('mass', 3) on a free body, and flush",
    'btRigidBody.setMassProps',
    twoBoxes,
    heavier,
  ),
  massOfHinged: walk(
    "set('mass', 3) on a body with a hinge, and flush",
    'btRigidBody.setMassProps',
    hinged,
    heavier,
  ),
  step: walk(
    'one step of two free bodies',
    'btDiscreteDynamicsWorld.stepSimulation',
    twoBoxes,
    ({ world }) => world.step(),
  ),
  begin: walk(
    'two free bodies are added, and three steps',
    'btDiscreteDynamicsWorld.stepSimulation',
    empty,
    ({ world }) => {
      addBoxes(world);
      world.step(3);
    },
  ),
  body: walk(
    'a free body is added, and flush',
    'btDiscreteDynamicsWorld.addRigidBody',
    empty,
    ({ world }) => {
      world.add('RigidBody', box);
      world.flush();
    },
  ),
  hinge: walk(
    'a hinge is added, and flush',
    'new JointConstraint',
    twoBoxes,
    ({ world, upper, lower }) => {
      addHinge(world, upper, lower);
      world.flush();
    },
  ),
  hinges: walk(
    'two hinges are added, and a step',
    'new JointConstraint',
    twoBoxes,
    ({ world, upper, lower }) => {
      addHinge(world, upper, lower);
      world.add('SingleAxisHingeJoint', { body1: upper, anchorPoint: [0, 9, 0], axis: [0, 0, 1] });
      world.step();
    },
  ),
  angle: walk('angle of a hinge is read', 'HeapReader.pose', hinged, ({ joint }) =>
    joint.get('angle'),
  ),
};

/** The calls of a walk. */
export async function walked(core: Instrumented, { begin }: Walk): Promise<Call[]> {
  const { world, go } = await begin(core);
  try {
    return recorder.record(go);
  } finally {
    world.destroy();
  }
}
