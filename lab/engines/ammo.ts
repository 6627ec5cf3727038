import type { Ammo } from '../../physics-core/engine/ammo.js';
import { massOf, momentsOf } from './bodies.js';
import { BulletScene, type BtConstraint, type Ways } from './bullet-scene.js';
import { NotOffered, sweep, type Engine, type Setting } from './engine.js';
import type { CaseBody, CaseScene, Vec3 } from '../case.js';
import { plansOf, type Plan, type Spring } from './joints.js';

/** Bullet's own iterations. */
export const DEFAULT_ITERATIONS = 10;

/** Softness and bias of a hinge's stops: what Bullet's own header suggests. */
const STOP_SOFTNESS = 0.9;
const STOP_BIAS = 0.3;

type SprungConstraint = Ammo['btGeneric6DofSpringConstraint']['prototype'];

/** The row of a 6-DoF that stands for the way along z. */
const ALONG_Z = 2;

function ball(scene: BulletScene, { ends: [a, b] }: Plan): BtConstraint {
  const { ammo } = scene;
  return new ammo.btPoint2PointConstraint(
    scene.at(a),
    scene.at(b),
    scene.vector(a.anchor),
    scene.vector(b.anchor),
  );
}

/** Bullet counts the turn of its first body against its second. */
function hinge(scene: BulletScene, { ends: [a, b], stops, motor }: Plan, dt: number): BtConstraint {
  const { ammo } = scene;
  const made = new ammo.btHingeConstraint(
    scene.at(a),
    scene.at(b),
    scene.vector(a.anchor),
    scene.vector(b.anchor),
    scene.vector(a.axis),
    scene.vector(b.axis),
    false,
  );
  if (stops) made.setLimit(stops.low, stops.high, STOP_SOFTNESS, STOP_BIAS, stops.bounce);
  if (motor) made.enableAngularMotor(true, motor.speed, motor.most * dt);
  return made;
}

/** And the way of its second along the axis of its first. */
function slider(scene: BulletScene, { ends: [b, a], stops }: Plan): BtConstraint {
  if (stops?.bounce) throw new NotOffered('stops of a slider that give back speed');
  const { ammo } = scene;
  const frames = [scene.frame(a, 'x'), scene.frame(b, 'x')] as const;
  const made = new ammo.btSliderConstraint(scene.at(a), scene.at(b), ...frames, true);
  made.setLowerLinLimit(stops?.low ?? 1);
  made.setUpperLinLimit(stops?.high ?? -1);
  made.setLowerAngLimit(0);
  made.setUpperAngLimit(0);
  return made;
}

/** Bullet turns a 6-DoF about z of its first frame and x of its second; y in the middle is held. */
function cross(scene: BulletScene, { ends: [a, b], spring }: Plan): BtConstraint {
  const { ammo } = scene;
  const kind = spring ? ammo.btGeneric6DofSpringConstraint : ammo.btGeneric6DofConstraint;
  const frames = [scene.frame(a, 'z'), scene.frame(b, 'x')] as const;
  const made = new kind(scene.at(a), scene.at(b), ...frames, true);
  // Lower above upper: free.
  made.setLinearLowerLimit(scene.vector([0, 0, spring ? 1 : 0]));
  made.setLinearUpperLimit(scene.vector([0, 0, spring ? -1 : 0]));
  made.setAngularLowerLimit(scene.vector([1, 0, 1]));
  made.setAngularUpperLimit(scene.vector([-1, 0, -1]));
  if (spring) suspend(made as SprungConstraint, spring);
  return made;
}

function suspend(joint: SprungConstraint, { stiffness, damping }: Spring): void {
  if (damping > 0) throw new NotOffered('a damper: that of a 6-DoF spring has no unit');
  joint.enableSpring(ALONG_Z, true);
  joint.setStiffness(ALONG_Z, stiffness);
  joint.setEquilibriumPoint(ALONG_Z, 0);
}

const JOINTS = { ball, hinge, slider, cross };

/** A joint as everybody makes it, with Bullet's own defaults. */
export const bulletJoint = (scene: BulletScene, plan: Plan, dt: number): BtConstraint =>
  JOINTS[plan.kind](scene, plan, dt);

/** Bullet's damping takes the same share of the speed in every second, as a drag of k newton seconds per metre does. */
const lost = (k: number | undefined, inertia: number): number => 1 - Math.exp(-(k ?? 0) / inertia);

function damping(body: CaseBody): { linear: number; angular: number } {
  const [x, y, z] = momentsOf(body);
  if (body.angularDampingFactor && (x !== y || y !== z))
    throw new NotOffered('angular drag of a body that is not round');
  return {
    linear: lost(body.linearDampingFactor, massOf(body)),
    angular: lost(body.angularDampingFactor, x),
  };
}

const ways = (dt: number): Ways => ({
  shape: (scene, { shape, offset, fixed }) =>
    offset ? scene.compound(shape!, offset) : scene.primitive(shape!, !fixed),
  moments: (scene, body, shape): Vec3 => {
    if (body.inertia) return body.inertia;
    const out = scene.vector([0, 0, 0]);
    shape.calculateLocalInertia(massOf(body), out);
    return [out.x(), out.y(), out.z()];
  },
  material: ({ bounce, friction }) => ({
    bounce: Math.sqrt(bounce),
    friction: Math.sqrt(friction),
  }),
  damping,
  joint: (scene, plan) => bulletJoint(scene, plan, dt),
});

async function make(scene: CaseScene, { step, iterations }: Setting) {
  const plans = plansOf(scene);
  const made = await BulletScene.make(scene, ways(step), plans);
  const { world } = made;
  world.getSolverInfo().set_m_numIterations(iterations);
  return made.running(step, () => {
    made.moveOn(step);
    made.applyForces();
    world.stepSimulation(step, 0);
  });
}

export const ammo: Engine = {
  id: 'ammo',
  name: 'raw Ammo',
  says: 'Bullet as ammo.js has it, default settings, the joints everybody makes (point-to-point, hinge, slider, 6-DoF), one step of the given length at a time.',
  settings: sweep([DEFAULT_ITERATIONS]),
  make,
};
