import type { CaseBody, CaseScene, Vec3 } from '../case.js';
import { massOf } from './bodies.js';
import { bulletJoint, DEFAULT_ITERATIONS } from './ammo.js';
import { BulletScene, type BtConstraint, type BtShape, type Ways } from './bullet-scene.js';
import { NotOffered, type Engine, type Setting } from './engine.js';
import { plansOf, type Plan } from './joints.js';

// What X_ITE 15.0.1 does in its RigidBodyPhysicsComponent.js, on our build of Ammo.

/** A steady one: X_ITE takes the frame rate of the browser, averaged over 15 frames. */
const FRAME = 1 / 60;

/** Bullet takes the inertia of the box around it. */
const compound = (scene: BulletScene, { shape, offset }: CaseBody): BtShape =>
  scene.compound(shape!, offset);

function joint(scene: BulletScene, plan: Plan): BtConstraint {
  if (plan.kind === 'cross') throw new NotOffered('UniversalJoint, an empty shell in X_ITE');
  if (plan.kind === 'slider')
    throw new NotOffered('SliderJoint, whose bodies jump to one place when it starts');
  if (plan.stops) throw new NotOffered('stops, which X_ITE does not read');
  if (plan.motor) throw new NotOffered('motors of hinges, which X_ITE does not read');
  return bulletJoint(scene, plan, FRAME);
}

const ways: Ways = {
  shape: compound,
  moments: (scene, body, shape): Vec3 => {
    const out = scene.vector([0, 0, 0]);
    shape.calculateLocalInertia(massOf(body), out);
    return [out.x(), out.y(), out.z()];
  },
  material: (contact) => contact,
  damping: ({ linearDampingFactor = 0.001, angularDampingFactor = 0.001 }) => ({
    linear: linearDampingFactor,
    angular: angularDampingFactor,
  }),
  joint,
};

function check({ bodies }: CaseScene): void {
  if (bodies.some(({ inertia }) => inertia))
    throw new NotOffered('inertia, which X_ITE does not read');
  if (bodies.some(({ path, turn }) => path ?? turn))
    throw new NotOffered(
      'fixed bodies that are moved: X_ITE teleports them, which moves nothing along',
    );
}

async function make(scene: CaseScene, { step, iterations }: Setting) {
  check(scene);
  const plans = plansOf(scene);
  if (plans.pushes.length > 0)
    throw new NotOffered('MotorJoint (an empty shell in X_ITE) and sliderForce');
  const made = await BulletScene.make(scene, ways, plans);
  const { world } = made;
  world.getSolverInfo().set_m_numIterations(DEFAULT_ITERATIONS);
  return made.running(FRAME, () => {
    for (let i = 0; i < iterations; i++) {
      made.applyForces();
      world.stepSimulation(step, 0);
    }
  });
}

const SPLITS = [1, 2, 4, 10, 16, 32];

export const xIte: Engine = {
  id: 'x-ite',
  name: "X_ITE's rule",
  says: 'The stepping of X_ITE 15.0.1 with preferAccuracy: a frame, here a steady 1/60 s, split in as many steps as its field iterations says (10 by default); bodies, materials and joints as X_ITE makes them, with a fixed body for the world. (Without preferAccuracy X_ITE takes interpolated poses for true ones, and bodies fall behind: at 10 iterations they go 4 % less far than their speed says, measured in Chromium.)',
  settings: SPLITS.map((split) => ({ step: FRAME / split, iterations: split })),
  make,
};
