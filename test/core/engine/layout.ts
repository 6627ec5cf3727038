// Bullet's objects lie on the heap as `offsets.ts` says: what was written by Ammo's methods is found there, and the other way round.
import type { Ammo } from '../../../physics-core/engine/ammo.js';
import { BodyReader, type BtBody } from '../../../physics-core/engine/heap.js';
import { Owner } from '../../../physics-core/engine/owner.js';
import type { SolverHook } from '../../../physics-core/engine/solver-hook.js';
import { StepStages } from '../../../physics-core/engine/step-stages.js';
import {
  BODY,
  BROADPHASE,
  DISPATCHER,
  ISLANDS,
  LEAF,
  MANIFOLD,
  MANIFOLD_POINT,
  PROXY,
  SHAPE,
  SHAPE_TYPE,
  SIX_DOF,
  SOLVER,
  WORLD,
} from '../../../physics-core/engine/offsets.js';

/** Bytes of a btMatrix3x3, which a btTransform's origin follows. */
const MATRIX = 48;

const close = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6 * Math.max(1, Math.abs(b));

/** What stands at an address. */
const wordAt = ({ HEAP32 }: Ammo, at: number): number => HEAP32[at >> 2]!;
const floatAt = ({ HEAPF32 }: Ammo, at: number): number => HEAPF32[at >> 2]!;

/** Asks objects that are gone afterwards. */
function asking<T>(ammo: Ammo, ask: (owner: Owner) => T): T {
  const owner = new Owner(ammo);
  try {
    return ask(owner);
  } finally {
    owner.dispose();
  }
}

/** One body with odd values, written by Ammo's methods, is found at our offsets. */
export const bodyOffsetsHold = (ammo: Ammo): boolean =>
  asking(ammo, (owner) => {
    const vector = owner.own(new ammo.btVector3(2, 3, 4));
    const shape = owner.own(new ammo.btBoxShape(vector));
    const info = owner.own(new ammo.btRigidBodyConstructionInfo(4, null as never, shape, vector));
    const body = owner.own(new ammo.btRigidBody(info));
    const transform = owner.own(new ammo.btTransform());
    const rotation = owner.own(new ammo.btQuaternion(0.48, 0.6, 0, 0.64));
    transform.setIdentity();
    vector.setValue(1.25, -7.5, 0.375);
    transform.setOrigin(vector);
    transform.setRotation(rotation);
    body.setCenterOfMassTransform(transform);
    vector.setValue(0.5, 11, -3);
    body.setLinearVelocity(vector);
    vector.setValue(-9, 0.125, 6);
    body.setAngularVelocity(vector);
    const pointer = ammo.getPointer(body);
    const reader = new BodyReader(ammo);
    const fast = stateOf(ammo, body);
    const sure = stateByMethods(body);
    vector.setValue(7, -8, 9);
    body.applyCentralForce(vector);
    vector.setValue(10, 11, -12);
    body.applyTorque(vector);
    const load = new Float64Array(6);
    reader.load(pointer, load, 0);
    transform.setIdentity();
    const other = owner.own(new ammo.btTransform());
    other.setIdentity();
    vector.setValue(-11, 12, -13);
    other.setOrigin(vector);
    const joints = [true, false].map((flag) => {
      const joint = new ammo.btGeneric6DofConstraint(body, body, transform, other, flag);
      return sixDofOffsetsHold(ammo, owner.own(joint), flag);
    });
    body.forceActivationState(5);
    return (
      shapeOffsetsHold(ammo, owner) &&
      fast.every((value, i) => close(value, sure[i]!)) &&
      joints.every(Boolean) &&
      String(load) === '7,-8,9,10,11,-12' &&
      wordAt(ammo, pointer + BODY.activationState) === 5 &&
      close(floatAt(ammo, pointer + BODY.inverseMass), 0.25) &&
      close(floatAt(ammo, pointer + BODY.inverseInertiaLocal), 0.5)
    );
  });

function shapeOffsetsHold(ammo: Ammo, owner: Owner): boolean {
  const typeOf = (shape: Ammo['btCollisionShape']['prototype']): number =>
    wordAt(ammo, ammo.getPointer(owner.own(shape)) + SHAPE.type);
  return (
    typeOf(new ammo.btConvexHullShape()) === SHAPE_TYPE.hull &&
    typeOf(new ammo.btCompoundShape(true)) === SHAPE_TYPE.compound
  );
}

/** Its frames, its flags, and its limits as the API writes them. */
function sixDofOffsetsHold(
  ammo: Ammo,
  joint: Ammo['btGeneric6DofConstraint']['prototype'],
  linearReferenceFrameA: boolean,
): boolean {
  const pointer = ammo.getPointer(joint);
  const flags = pointer + SIX_DOF.useLinearReferenceFrameA;
  asking(ammo, (owner) => {
    const limit = (x: number, y: number, z: number) => owner.own(new ammo.btVector3(x, y, z));
    joint.setLinearLowerLimit(limit(-1, -2, -3));
    joint.setLinearUpperLimit(limit(1, 2, 3));
    joint.setAngularLowerLimit(limit(-0.25, -0.5, -0.75));
    joint.setAngularUpperLimit(limit(0.25, 0.5, 0.75));
  });
  const at = (offset: number): number => floatAt(ammo, pointer + offset);
  const placed = [0, 1, 2].every((i) => {
    const angle = SIX_DOF.angularLower + i * SIX_DOF.angularSize;
    return (
      at(SIX_DOF.linearLower + 4 * i) === -1 - i &&
      at(SIX_DOF.linearUpper + 4 * i) === 1 + i &&
      close(at(angle), -0.25 * (1 + i)) &&
      close(at(angle + 4), 0.25 * (1 + i))
    );
  });
  const frames =
    ammo.getPointer(joint.getFrameOffsetA()) - pointer === SIX_DOF.frameA &&
    [-11, 12, -13].every((value, i) => at(SIX_DOF.frameB + MATRIX + 4 * i) === value);
  return (
    frames &&
    placed &&
    ammo.HEAPU8[flags] === +linearReferenceFrameA &&
    ammo.HEAPU8[flags + 1] === 1
  );
}

/** A fresh world's btContactSolverInfo: its defaults pin the build (Bullet 2.82). */
export const solverOffsetsHold = (ammo: Ammo): boolean =>
  asking(ammo, (owner) => {
    const pointer = ammo.getPointer(sunkCubes(ammo, owner).world.getSolverInfo());
    return defaultsHold(ammo, pointer);
  });

function defaultsHold(ammo: Ammo, pointer: number): boolean {
  const at = (offset: number): number => floatAt(ammo, pointer + offset);
  return (
    wordAt(ammo, pointer + SOLVER.iterations) === 10 &&
    close(at(0), 0.6) &&
    close(at(SOLVER.errorReduction), 0.2) &&
    close(at(SOLVER.errorReduction2), 0.8) &&
    close(at(SOLVER.splitImpulseThreshold), -0.04) &&
    close(at(SOLVER.warmstarting), 0.85) &&
    wordAt(ammo, pointer + SOLVER.mode) === 260
  );
}

/** A world of two cubes of 2 m, one of which has sunk 0.1 m into the other. */
function sunkCubes(ammo: Ammo, owner: Owner) {
  const vector = owner.own(new ammo.btVector3(1, 1, 1));
  const shape = owner.own(new ammo.btBoxShape(vector));
  const configuration = owner.own(new ammo.btDefaultCollisionConfiguration());
  const dispatcher = owner.own(new ammo.btCollisionDispatcher(configuration));
  const broadphase = owner.own(new ammo.btDbvtBroadphase());
  const solver = owner.own(new ammo.btSequentialImpulseConstraintSolver());
  const world = owner.own(
    new ammo.btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
  );
  const transform = owner.own(new ammo.btTransform());
  transform.setIdentity();
  const bodies = [0, 1].map((mass) => {
    const info = owner.own(
      new ammo.btRigidBodyConstructionInfo(mass, null as never, shape, vector),
    );
    const body = owner.own(new ammo.btRigidBody(info));
    vector.setValue(0, 1.9 * mass, 0);
    transform.setOrigin(vector);
    body.setCenterOfMassTransform(transform);
    world.addRigidBody(body);
    return body;
  });
  const end = (): void => {
    for (const body of bodies) world.removeRigidBody(body);
  };
  return { dispatcher, broadphase, solver, world, shape, bodies, vector, end };
}

type SunkCubes = ReturnType<typeof sunkCubes>;

/** Where their contact points are, how they live, and whether the hook is called when they are found and when they are solved. */
export const manifoldOffsetsHold = (ammo: Ammo, hook: SolverHook): boolean =>
  asking(ammo, (owner) => {
    const { dispatcher, solver, world, end } = sunkCubes(ammo, owner);
    const called: string[] = [];
    hook.attach(ammo.getPointer(solver));
    hook.listen({
      found: () => called.push(`found ${dispatcher.getNumManifolds()}`),
      solved: () => called.push('solved'),
    });
    world.stepSimulation(1e-3, 0);
    hook.listen(null);
    const holds = called.join() === 'found 1,solved' && layoutHolds(ammo, dispatcher);
    end();
    return holds;
  });

/** Steps stage by stage move two bodies as Bullet's own do, which tell where its seconds are to be written. */
export const stagesHold = (ammo: Ammo): boolean =>
  asking(ammo, (owner) => {
    const worlds = [sunkCubes(ammo, owner), sunkCubes(ammo, owner)] as const;
    const [theirs, ours] = worlds.map(({ world }) => ammo.getPointer(world)) as [number, number];
    new StepStages(ammo).attach(ours);
    let known = true;
    const [expected, found] = worlds.map((each) => {
      const { world, bodies, vector, end } = each;
      vector.setValue(3, -2, 1);
      bodies[1]!.setAngularVelocity(vector);
      for (let step = 0; step < 3; step++) world.stepSimulation(1 / 64, 0);
      known &&= tablesHold(ammo, each);
      end();
      return stateOf(ammo, bodies[1]!);
    });
    return (
      known &&
      [WORLD.dispatchInfo, WORLD.solverInfo + SOLVER.timeStep].every(
        (offset) => floatAt(ammo, theirs + offset) === 1 / 64,
      ) &&
      String(expected) === String(found)
    );
  });

/** Where Bullet's tables are in which `SolveOrder` and `KeptWorld` read and write: of one fixed cube, and one that moves. */
function tablesHold(
  ammo: Ammo,
  { world, broadphase, dispatcher, shape, bodies }: SunkCubes,
): boolean {
  const word = (at: number): number => wordAt(ammo, at);
  const at = ammo.getPointer(world);
  const pairs = ammo.getPointer(broadphase);
  const [first, second] = bodies.map((body) => ammo.getPointer(body)) as [number, number];
  const proxies = [first, second].map((body) => word(body + BODY.proxy));
  const islands = word(at + WORLD.islands);
  const leafHolds = (proxy: number): boolean =>
    word(word(proxy + PROXY.leaf) + LEAF.proxy) === proxy &&
    word(word(proxy + PROXY.leaf) + LEAF.parent) === word(pairs + BROADPHASE.moving);
  return (
    word(at + WORLD.objectCount) === 2 &&
    word(word(at + WORLD.objects)) === first &&
    word(at + WORLD.constraintCount) === 0 &&
    word(at + WORLD.broadphase) === pairs &&
    word(first + BODY.shape) === ammo.getPointer(shape) &&
    proxies.every(leafHolds) &&
    word(proxies[1]! + PROXY.body) === second &&
    word(proxies[1]! + PROXY.id) === word(proxies[0]! + PROXY.id) + 1 &&
    word(proxies[1]! + PROXY.list) < 2 &&
    word(pairs + BROADPHASE.moving + BROADPHASE.leaves) === 2 &&
    word(pairs + BROADPHASE.list) < 2 &&
    word(pairs + BROADPHASE.cleanup) === 10 &&
    ammo.HEAPU8[pairs + BROADPHASE.deferred] === 0 &&
    word(islands + ISLANDS.count) === 1 &&
    // The second of all objects is the one that moves.
    word(word(islands + ISLANDS.elements) + 4) === 1 &&
    word(ammo.getPointer(dispatcher.getManifoldByIndexInternal(0)) + MANIFOLD.index) === 0
  );
}

function stateOf(ammo: Ammo, body: BtBody): Float64Array {
  const reader = new BodyReader(ammo);
  const state = new Float64Array(13);
  reader.pose(ammo.getPointer(body), state, 0);
  reader.velocity(ammo.getPointer(body), state, 7);
  return state;
}

/** The same by Ammo's methods. */
export function stateByMethods(body: BtBody): Float64Array {
  const transform = body.getWorldTransform();
  const vectors = [transform.getOrigin(), body.getLinearVelocity(), body.getAngularVelocity()];
  const [origin, linear, angular] = vectors.map((v) => [v.x(), v.y(), v.z()]) as number[][];
  const q = transform.getRotation();
  return Float64Array.of(...origin!, q.x(), q.y(), q.z(), q.w(), ...linear!, ...angular!);
}

function layoutHolds(ammo: Ammo, dispatcher: Ammo['btCollisionDispatcher']['prototype']): boolean {
  const word = (at: number): number => wordAt(ammo, at);
  const manifold = dispatcher.getManifoldByIndexInternal(0);
  const all = ammo.getPointer(dispatcher);
  const at = ammo.getPointer(manifold);
  const first = at + MANIFOLD.points;
  const count = manifold.getNumContacts();
  return (
    count > 1 &&
    word(all + DISPATCHER.manifoldCount) === 1 &&
    word(word(all + DISPATCHER.manifolds)) === at &&
    word(at + MANIFOLD.bodyA) === ammo.getPointer(manifold.getBody0()) &&
    word(at + MANIFOLD.bodyB) === ammo.getPointer(manifold.getBody1()) &&
    word(at + MANIFOLD.pointCount) === count &&
    // A fiftieth of the way from the middle to a corner.
    close(floatAt(ammo, at + MANIFOLD.breaking), 0.02 * Math.sqrt(3)) &&
    ammo.getPointer(manifold.getContactPoint(0)) === first &&
    ammo.getPointer(manifold.getContactPoint(1)) === first + MANIFOLD_POINT.size &&
    floatAt(ammo, first + MANIFOLD_POINT.distance) === manifold.getContactPoint(0).getDistance() &&
    localsHold(ammo, first)
  );
}

/** The top of the lower box, the bottom of the upper one. */
function localsHold(ammo: Ammo, point: number): boolean {
  const y = (local: number): number => floatAt(ammo, point + local + 4);
  return close(y(MANIFOLD_POINT.localA), 1) && close(y(MANIFOLD_POINT.localB), -1);
}
