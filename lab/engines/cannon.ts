import * as CANNON from 'cannon-es';
import { conjugate, multiply, rotate, rotationOf, scale } from '../../physics-core/base/math.js';
import type { Pose } from '../../physics-core/base/math.js';
import type { CaseBody, CaseScene, Quaternion, Shape, Vec3 } from '../case.js';
import { forceOn, guideOf, isRound, massOf, momentsOf, poseOf, torqueOn } from './bodies.js';
import { NotOffered, sweep, type Engine, type Running, type Setting } from './engine.js';
import { plansOf, type End, type Plan, type Push } from './joints.js';

const vec = ([x, y, z]: Vec3) => new CANNON.Vec3(x, y, z);
const xyz = ({ x, y, z }: CANNON.Vec3): Vec3 => [x, y, z];
const xyzw = ({ x, y, z, w }: CANNON.Quaternion): Quaternion => [x, y, z, w];

/** Sides of a cylinder, which cannon-es makes of polygons. */
const SIDES = 32;

function shapeOf(shape: Shape): CANNON.Shape {
  if (shape.type === 'IndexedTriangleSet' || shape.type === 'ElevationGrid')
    throw new NotOffered('meshes and fields that boxes and cylinders meet');
  if (shape.type === 'Sphere') return new CANNON.Sphere(shape.radius);
  if (shape.type === 'Box') return new CANNON.Box(vec(scale(shape.size, 0.5)));
  const { radius, height } = shape;
  return new CANNON.Cylinder(radius, radius, height, SIDES);
}

/** cannon-es takes the same share of the speed in every second, as a drag of k newton seconds per metre does. */
const lost = (k: number | undefined, inertia: number): number => 1 - Math.exp(-(k ?? 0) / inertia);

function bodyOf(body: CaseBody, collides: boolean): CANNON.Body {
  const { p, q } = poseOf(body);
  const made = new CANNON.Body({
    mass: body.fixed ? 0 : massOf(body),
    ...(guideOf(body) && { type: CANNON.Body.KINEMATIC }),
    position: vec(p),
    quaternion: new CANNON.Quaternion(...q),
    velocity: vec(body.linearVelocity ?? [0, 0, 0]),
    angularVelocity: vec(body.angularVelocity ?? [0, 0, 0]),
    linearDamping: 0,
    angularDamping: 0,
    ...(!collides && { collisionFilterMask: 0 }),
  });
  if (body.shape) made.addShape(shapeOf(body.shape), vec(body.offset ?? [0, 0, 0]));
  if (!body.fixed) weigh(made, body);
  return made;
}

/** cannon-es itself would take the inertia of the box around the shape. */
function weigh(made: CANNON.Body, body: CaseBody): void {
  const [x, y, z] = momentsOf(body);
  made.inertia.set(x, y, z);
  made.invInertia.set(1 / x, 1 / y, 1 / z);
  made.updateInertiaWorld(true);
  if (!body.autoDamp) return;
  if (body.angularDampingFactor && !isRound(body))
    throw new NotOffered('angular drag of a body that is not round');
  made.linearDamping = lost(body.linearDampingFactor, massOf(body));
  made.angularDamping = lost(body.angularDampingFactor, x);
}

/** What page code has to do before each step. */
function forcesOf(body: CaseBody, made: CANNON.Body, gravity: Vec3): (() => void)[] {
  const weight = body.useGlobalGravity === false ? scale(gravity, -massOf(body)) : [0, 0, 0];
  const force = vec(forceOn(body).map((f, i) => f + weight[i]!) as Vec3);
  const torque = vec(torqueOn(body));
  const { pull } = body;
  return [
    ...(pull ? [() => made.applyForce(vec(pull(xyz(made.position))))] : []),
    ...(force.isZero() ? [] : [() => made.applyForce(force)]),
    ...(torque.isZero() ? [] : [() => made.applyTorque(torque)]),
  ];
}

/** Moved by its velocity: to where it is to be at the end of the step. */
function moverOf(made: CANNON.Body, guide: (time: number) => Pose, dt: number): () => void {
  let steps = 0;
  return () => {
    const { p, q } = guide(++steps * dt);
    vec(p).vsub(made.position, made.velocity);
    made.velocity.scale(1 / dt, made.velocity);
    const [x, y, z, angle] = rotationOf(multiply(q, conjugate(xyzw(made.quaternion))));
    made.angularVelocity.set(x, y, z).scale(angle / dt, made.angularVelocity);
  };
}

interface Place {
  at(end: End): CANNON.Body;
  /** Seconds of a step. */
  dt: number;
}

function ball({ ends: [a, b] }: Plan, { at }: Place): CANNON.Constraint {
  return new CANNON.PointToPointConstraint(at(a), vec(a.anchor), at(b), vec(b.anchor));
}

function hinge({ ends: [a, b], stops, motor }: Plan, { at, dt }: Place): CANNON.Constraint {
  if (stops) throw new NotOffered('stops of a hinge');
  const made = new CANNON.HingeConstraint(at(a), at(b), {
    pivotA: vec(a.anchor),
    axisA: vec(a.axis),
    pivotB: vec(b.anchor),
    axisB: vec(b.axis),
    collideConnected: false,
  });
  if (motor) {
    made.enableMotor();
    made.setMotorSpeed(motor.speed);
    // What cannon-es calls a force it takes as what one step may give (measured).
    made.setMotorMaxForce(motor.most * dt);
  }
  return made;
}

function jointOf(plan: Plan, place: Place): CANNON.Constraint {
  if (plan.kind === 'slider') throw new NotOffered('sliders');
  if (plan.kind === 'cross') throw new NotOffered('universal joints');
  const made = plan.kind === 'ball' ? ball(plan, place) : hinge(plan, place);
  made.collideConnected = false;
  return made;
}

function pushOf({ kind, vector }: Push, one: CANNON.Body, other?: CANNON.Body): () => void {
  const apply = (body: CANNON.Body, v: Vec3) =>
    kind === 'force' ? body.applyForce(vec(v)) : body.applyTorque(vec(v));
  return () => {
    const now = rotate(xyzw(one.quaternion), vector);
    apply(one, now);
    if (other) apply(other, scale(now, -1));
  };
}

async function make(scene: CaseScene, { step, iterations }: Setting): Promise<Running> {
  const { joints, pushes } = plansOf(scene);
  const { contact, gravity } = scene;
  const world = new CANNON.World({ gravity: vec(gravity) });
  (world.solver as CANNON.GSSolver).iterations = iterations;
  world.defaultContactMaterial.friction = contact?.friction ?? 0;
  world.defaultContactMaterial.restitution = contact?.bounce ?? 0;
  const ground = new CANNON.Body({ mass: 0 });
  const bodies = new Map<string, CANNON.Body>();
  const forces: (() => void)[] = [];
  for (const body of scene.bodies) {
    const made = bodyOf(body, Boolean(contact));
    world.addBody(made);
    bodies.set(body.name, made);
    const guide = guideOf(body);
    if (guide) forces.push(moverOf(made, guide, step));
    if (!body.fixed) forces.push(...forcesOf(body, made, gravity));
  }
  const at = ({ body }: End) => (body === undefined ? ground : bodies.get(body)!);
  for (const plan of joints) world.addConstraint(jointOf(plan, { at, dt: step }));
  for (const push of pushes)
    forces.push(pushOf(push, bodies.get(push.body1)!, bodies.get(push.body2 ?? '')));
  return {
    timeStep: step,
    step: () => {
      for (const apply of forces) apply();
      world.step(step);
    },
    position: (name) => xyz(bodies.get(name)!.position),
    orientation: (name) => xyzw(bodies.get(name)!.quaternion),
    linearVelocity: (name) => xyz(bodies.get(name)!.velocity),
    angularVelocity: (name) => xyz(bodies.get(name)!.angularVelocity),
    contacts: () => world.contacts.length,
    effects: () => [],
    destroy: () => {},
  };
}

export const cannon: Engine = {
  id: 'cannon',
  name: 'cannon-es',
  says: 'cannon-es 0.20, its defaults (10 iterations) and 50 iterations; inertia set by hand, for its own is that of the box around a shape.',
  settings: sweep([10, 50]),
  make,
};
