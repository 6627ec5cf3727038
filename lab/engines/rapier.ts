import RAPIER from '@dimforge/rapier3d-compat';
import { add, cross, quaternionOfAxes, rotate, scale } from '../../physics-core/base/math.js';
import type { CaseBody, CaseScene, Heights, Quaternion, Shape, Triangles, Vec3 } from '../case.js';
import {
  forceOn,
  guideOf,
  isHull,
  isRound,
  massOf,
  middleOf,
  momentsOf,
  poseOf,
  torqueOn,
} from './bodies.js';
import { NotOffered, sweep, type Engine, type Running, type Setting } from './engine.js';
import { plansOf, type End, type Plan, type Push } from './joints.js';

const vec = ([x, y, z]: Vec3) => ({ x, y, z });
const xyz = ({ x, y, z }: RAPIER.Vector): Vec3 => [x, y, z];
const xyzw = ({ x, y, z, w }: RAPIER.Rotation): Quaternion => [x, y, z, w];
const turn = ([x, y, z, w]: Quaternion) => ({ x, y, z, w });

let ready: Promise<void> | undefined;

/** A collider's groups: none with none. */
const NOTHING = 0;

/** Rapier has its heights column by column, over a field about its middle. */
function field(grid: Heights): RAPIER.ColliderDesc {
  const { xDimension, zDimension, height } = grid;
  const columns = height.map(
    (_, i) => height[(i % zDimension) * xDimension + Math.floor(i / zDimension)]!,
  );
  const [x, , z] = scale(middleOf(grid), 2);
  const size = { x, y: 1, z };
  const cells = [zDimension - 1, xDimension - 1] as const;
  return RAPIER.ColliderDesc.heightfield(...cells, new Float32Array(columns), size);
}

function triangles({ coord, index }: Triangles, hull: boolean): RAPIER.ColliderDesc {
  const points = new Float32Array(coord);
  return hull
    ? RAPIER.ColliderDesc.convexHull(points)!
    : RAPIER.ColliderDesc.trimesh(points, new Uint32Array(index));
}

function colliderOf(shape: Shape, hull: boolean): RAPIER.ColliderDesc {
  if (shape.type === 'ElevationGrid') return field(shape);
  if (shape.type === 'IndexedTriangleSet') return triangles(shape, hull);
  if (shape.type === 'Sphere') return RAPIER.ColliderDesc.ball(shape.radius);
  if (shape.type === 'Cylinder')
    return RAPIER.ColliderDesc.cylinder(shape.height / 2, shape.radius);
  const [x, y, z] = scale(shape.size, 0.5);
  return RAPIER.ColliderDesc.cuboid(x, y, z);
}

function bodyDescOf(body: CaseBody): RAPIER.RigidBodyDesc {
  const { p, q } = poseOf(body);
  const desc = guideOf(body)
    ? RAPIER.RigidBodyDesc.kinematicPositionBased()
    : body.fixed
      ? RAPIER.RigidBodyDesc.fixed()
      : RAPIER.RigidBodyDesc.dynamic();
  desc
    .setTranslation(...p)
    .setRotation(turn(q))
    .setCanSleep(false);
  if (body.fixed) return desc;
  desc.setLinvel(...(body.linearVelocity ?? [0, 0, 0]));
  desc.setAngvel(vec(body.angularVelocity ?? [0, 0, 0]));
  if (body.useGlobalGravity === false) desc.setGravityScale(0);
  const inertia = vec(momentsOf(body));
  desc.setAdditionalMassProperties(massOf(body), vec([0, 0, 0]), inertia, turn([0, 0, 0, 1]));
  if (!body.autoDamp) return desc;
  if (body.angularDampingFactor && !isRound(body))
    throw new NotOffered('angular drag of a body that is not round');
  desc.setLinearDamping((body.linearDampingFactor ?? 0) / massOf(body));
  return desc.setAngularDamping((body.angularDampingFactor ?? 0) / momentsOf(body)[0]);
}

function addBody(world: RAPIER.World, body: CaseBody, contact: CaseScene['contact']) {
  const made = world.createRigidBody(bodyDescOf(body));
  if (!body.shape) return made;
  // The body has its mass already.
  const collider = colliderOf(body.shape, isHull(body)).setDensity(0);
  const middle: Vec3 = body.shape.type === 'ElevationGrid' ? middleOf(body.shape) : [0, 0, 0];
  collider.setTranslation(...add(middle, body.offset ?? [0, 0, 0]));
  if (!contact) collider.setCollisionGroups(NOTHING);
  else collider.setFriction(contact.friction).setRestitution(contact.bounce);
  world.createCollider(collider, made);
  return made;
}

/** Forces stay on a Rapier body until they are taken back. */
function force(made: RAPIER.RigidBody, body: CaseBody): void {
  if (body.fixed) return;
  made.resetForces(true);
  made.resetTorques(true);
  made.addForce(vec(forceOn(body)), true);
  made.addTorque(vec(torqueOn(body)), true);
  if (body.pull) made.addForce(vec(body.pull(xyz(made.translation()))), true);
}

type BodyAt = (end: End) => RAPIER.RigidBody;

/** Rapier takes x of both frames as the axis; without frames of one's own it would choose the rest by itself. */
const frame = ({ axis, normal }: End): RAPIER.Rotation =>
  turn(quaternionOfAxes(axis, normal, cross(axis, normal)));

/** Rapier counts the turn and the way of its second body against its first. */
function addJoint(world: RAPIER.World, { kind, ends, stops, motor }: Plan, at: BodyAt): void {
  const [b, a] = ends;
  const [anchorA, anchorB] = [vec(a.anchor), vec(b.anchor)];
  if (kind === 'cross') throw new NotOffered('universal joints');
  if (stops?.bounce) throw new NotOffered('stops that give back speed');
  const data =
    kind === 'ball'
      ? RAPIER.JointData.spherical(anchorA, anchorB)
      : kind === 'hinge'
        ? RAPIER.JointData.revoluteWithAxes(anchorA, anchorB, vec(a.axis), vec(b.axis))
        : RAPIER.JointData.prismatic(anchorA, anchorB, vec(a.axis));
  const made = world.createImpulseJoint(data, at(a), at(b), true);
  if (kind !== 'ball') {
    made.setFrameX1(frame(a));
    made.setFrameX2(frame(b));
  }
  made.setContactsEnabled(false);
  const unit = made as RAPIER.UnitImpulseJoint;
  if (stops) unit.setLimits(stops.low, stops.high);
  if (!motor) return;
  unit.configureMotorModel(RAPIER.MotorModel.ForceBased);
  unit.configureMotorVelocity(motor.speed, MOTOR_GAIN);
  unit.setMotorMaxForce(motor.most);
}

/** Newton metre seconds: so stiff that the greatest torque is what limits the motor. */
const MOTOR_GAIN = 1e6;

function push({ kind, vector }: Push, one: RAPIER.RigidBody, other?: RAPIER.RigidBody): void {
  const now = rotate(xyzw(one.rotation()), vector);
  for (const [body, v] of [
    [one, now],
    [other, scale(now, -1)],
  ] as const) {
    if (kind === 'force') body?.addForce(vec(v), true);
    else body?.addTorque(vec(v), true);
  }
}

function contactsIn(world: RAPIER.World): number {
  let count = 0;
  world.forEachCollider((one) =>
    world.contactPairsWith(one, (other) =>
      world.contactPair(one, other, (manifold) => {
        if (one.handle < other.handle) count += manifold.numContacts();
      }),
    ),
  );
  return count;
}

async function make(scene: CaseScene, { step, iterations }: Setting): Promise<Running> {
  await (ready ??= RAPIER.init());
  const { joints, pushes } = plansOf(scene);
  const world = new RAPIER.World(vec(scene.gravity));
  world.timestep = step;
  world.numSolverIterations = iterations;
  const bodies = new Map<string, RAPIER.RigidBody>();
  for (const body of scene.bodies) bodies.set(body.name, addBody(world, body, scene.contact));
  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
  const at: BodyAt = ({ body }) => (body === undefined ? ground : bodies.get(body)!);
  for (const plan of joints) addJoint(world, plan, at);
  const forceAll = () => {
    for (const body of scene.bodies) force(bodies.get(body.name)!, body);
    for (const one of pushes) push(one, bodies.get(one.body1)!, bodies.get(one.body2 ?? ''));
  };
  const moved = scene.bodies.flatMap((body) => {
    const guide = guideOf(body);
    return guide ? [{ made: bodies.get(body.name)!, guide, turns: Boolean(body.turn) }] : [];
  });
  const pulled = scene.bodies.some(({ pull }) => pull);
  let steps = 0;
  forceAll();
  return {
    timeStep: step,
    step: () => {
      steps++;
      for (const { made, guide, turns } of moved) {
        const { p, q } = guide(steps * step);
        made.setNextKinematicTranslation(vec(p));
        if (turns) made.setNextKinematicRotation(turn(q));
      }
      // What turns with a body, or hangs on where it is, is given anew.
      if (pushes.length > 0 || pulled) forceAll();
      world.step();
    },
    position: (name) => xyz(bodies.get(name)!.translation()),
    orientation: (name) => xyzw(bodies.get(name)!.rotation()),
    linearVelocity: (name) => xyz(bodies.get(name)!.linvel()),
    angularVelocity: (name) => xyz(bodies.get(name)!.angvel()),
    contacts: () => contactsIn(world),
    effects: () => [],
    destroy: () => world.free(),
  };
}

export const rapier: Engine = {
  id: 'rapier',
  name: 'Rapier',
  says: 'Rapier 0.21 (rapier3d-compat), its defaults (4 solver iterations) and 16 iterations.',
  settings: sweep([4, 16]),
  make,
};
