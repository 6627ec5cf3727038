import { loadEngine } from '../physics-core/inside.js';
import { add, rotate } from '../physics-core/base/math.js';
import type { Chain } from '../test/core/chain-reference.js';

/** A chain as its end and a way to step it. */
export interface Stepped {
  timeStep: number;
  step(): void;
  end(): number[];
  destroy(): void;
}

/** The chain of balls or boxes in Ammo alone: point-to-point joints as everybody makes them, default settings. */
export async function rawChain(chain: Chain, timeStep: number): Promise<Stepped> {
  const { ammo } = await loadEngine();
  const made: object[] = [];
  const own = <T extends object>(object: T): T => (made.push(object), object);
  const vector = (x: number, y: number, z: number) => own(new ammo.btVector3(x, y, z));
  const configuration = own(new ammo.btDefaultCollisionConfiguration());
  const dispatcher = own(new ammo.btCollisionDispatcher(configuration));
  const broadphase = own(new ammo.btDbvtBroadphase());
  const solver = own(new ammo.btSequentialImpulseConstraintSolver());
  const world = own(
    new ammo.btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
  );
  world.setGravity(vector(0, -chain.gravity, 0));
  const { link, centre } = chain;
  const shape = own(
    centre === link
      ? new ammo.btSphereShape(0.1)
      : new ammo.btBoxShape(vector(0.45 * link, 0.2 * link, 0.2 * link)),
  );
  const bodies = chain.masses.map((mass, i) => {
    const inertia = vector(0, 0, 0);
    shape.calculateLocalInertia(mass, inertia);
    const start = own(new ammo.btTransform());
    start.setIdentity();
    start.setOrigin(vector(i * link + centre, 0, 0));
    const motion = own(new ammo.btDefaultMotionState(start));
    const info = own(new ammo.btRigidBodyConstructionInfo(mass, motion, shape, inertia));
    const body = own(new ammo.btRigidBody(info));
    body.setActivationState(4);
    // They collide with nothing: group 1, mask 0.
    world.addRigidBody(body, 1, 0);
    return body;
  });
  const joints = bodies.map((body, i) => {
    const before = bodies[i - 1];
    const mine = vector(-centre, 0, 0);
    const joint = before
      ? new ammo.btPoint2PointConstraint(body, before, mine, vector(link - centre, 0, 0))
      : new ammo.btPoint2PointConstraint(body, mine);
    world.addConstraint(own(joint), true);
    return joint;
  });
  const last = bodies.at(-1)!;
  return {
    timeStep,
    step: () => void world.stepSimulation(timeStep, 0),
    end: () => {
      const at = last.getWorldTransform();
      const [p, q] = [at.getOrigin(), at.getRotation()];
      return add(
        [p.x(), p.y(), p.z()],
        rotate([q.x(), q.y(), q.z(), q.w()], [link - centre, 0, 0]),
      );
    },
    destroy: () => {
      for (const joint of joints) world.removeConstraint(joint);
      for (const body of bodies) world.removeRigidBody(body);
      for (const object of made.reverse()) ammo.destroy(object);
    },
  };
}
