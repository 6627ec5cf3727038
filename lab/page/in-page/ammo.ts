import type { PageScene, Thing } from '../scene.js';

// Bullet as it comes out of Ammo, and nothing else of anybody's.

const page = window as any;
let world: any;
let first: any;

export async function begin({ things, hinges }: PageScene): Promise<void> {
  const locateFile = () => '/node_modules/ammojs-typed/ammo/ammo.wasm.wasm';
  const bullet = await page.Ammo.call({}, { locateFile });
  const vector = (x: number, y: number, z: number) => new bullet.btVector3(x, y, z);
  const settings = new bullet.btDefaultCollisionConfiguration();
  world = new bullet.btDiscreteDynamicsWorld(
    new bullet.btCollisionDispatcher(settings),
    new bullet.btDbvtBroadphase(),
    new bullet.btSequentialImpulseConstraintSolver(),
    settings,
  );
  world.setGravity(vector(0, -9.8, 0));

  const bodyOf = ({ shape: of, position, turn = 0, mass, damping = 0 }: Thing) => {
    const shape =
      typeof of === 'number'
        ? new bullet.btSphereShape(of)
        : new bullet.btBoxShape(vector(of[0] / 2, of[1] / 2, of[2] / 2));
    const pose = new bullet.btTransform();
    pose.setIdentity();
    pose.setOrigin(vector(...position));
    pose.setRotation(new bullet.btQuaternion(0, Math.sin(turn / 2), 0, Math.cos(turn / 2)));
    const inertia = vector(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    const motion = new bullet.btDefaultMotionState(pose);
    const info = new bullet.btRigidBodyConstructionInfo(mass, motion, shape, inertia);
    const body = new bullet.btRigidBody(info);
    body.setDamping(0, damping);
    // Awake for ever.
    body.setActivationState(4);
    world.addRigidBody(body);
    return body;
  };

  const bodies = new Map(things.map((thing) => [thing, bodyOf(thing)]));
  const inFrameOf = ({ position, turn = 0 }: Thing, at: readonly number[]) => {
    const [x, y, z] = at.map((value, i) => value - position[i]!) as [number, number, number];
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    return vector(x * c - z * s, y, x * s + z * c);
  };
  const up = vector(0, 1, 0);
  for (const { bodies: pair, anchor } of hinges) {
    const [one, other] = pair.map((thing) => bodies.get(thing));
    const pivots = pair.map((thing) => inFrameOf(thing, anchor));
    world.addConstraint(
      new bullet.btHingeConstraint(one, other, pivots[0], pivots[1], up, up, true),
      true,
    );
  }
  first = bodies.get(things[0]!);
  const turned = things.flatMap((thing) =>
    thing.motor ? [[bodies.get(thing), vector(0, thing.motor, 0)] as const] : [],
  );
  const frame = (): void => {
    for (let i = 0; i < 2; i++) {
      for (const [body, torque] of turned) body.applyTorque(torque);
      world.stepSimulation(1 / 120, 0);
    }
    requestAnimationFrame(frame);
  };
  frame();
}

export const ready = (): boolean => Boolean(world);
export const height = (): number | undefined => first?.getWorldTransform().getOrigin().y();
