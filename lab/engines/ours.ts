import { jointSolve } from '../../physics-core/inside.js';
import { loadEngine } from '../../physics-core/create.js';
import { levels, World, type Level } from '../../physics-core/inside.js';
import { add, cross, rotate, scale } from '../../physics-core/base/math.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { CaseBody, CaseScene, Vec3 } from '../case.js';
import { poseOf } from './bodies.js';
import { sweep, type Engine, type Running, type Setting } from './engine.js';

/** Its origin is in the middle of its shape. */
function fieldsOf(body: CaseBody): Record<string, unknown> {
  const { name: _, path: __, turn: ___, pull: ____, shape, offset, inertia, ...fields } = body;
  return {
    ...fields,
    ...(shape && { geometry: [shape] }),
    ...(inertia && { inertia: inertia.flatMap((moment, i) => [0, 0, 0].with(i, moment)) }),
    ...(offset && offCentre(body, offset)),
  };
}

function offCentre(body: CaseBody, offset: Vec3): Record<string, unknown> {
  const { p, q } = poseOf(body);
  const { linearVelocity = [0, 0, 0], angularVelocity = [0, 0, 0] } = body;
  const arm = rotate(q, offset);
  return {
    centerOfMass: scale(offset, -1),
    position: add(p, arm),
    linearVelocity: add(linearVelocity, cross(angularVelocity, arm)),
  };
}

function build(world: World, { gravity, bodies, joints = [], contact }: CaseScene) {
  world.add('RigidBodyCollection', { gravity, rest: 'never' });
  const nodes = new Map<string, BodyNode>();
  for (const body of bodies)
    nodes.set(body.name, world.add('RigidBody', fieldsOf(body)) as BodyNode);
  world.add('CollisionCollection', {
    collidables: '*',
    ...(contact
      ? {
          appliedParameters: ['BOUNCE', 'FRICTION_COEFFICIENT-2'],
          bounce: contact.bounce,
          frictionCoefficients: [contact.friction, contact.friction],
        }
      : { enabled: false }),
  });
  for (const { type, body1, body2, ...fields } of joints)
    world.add(type, {
      body1: nodes.get(body1),
      ...(body2 && { body2: nodes.get(body2) }),
      ...fields,
    });
  return nodes;
}

/** The level, or one of no name with the setting's step and iterations and all else as at `standard`. */
const levelOf = ({ level, step, iterations }: Setting): Level =>
  levels.find(({ name }) => name === level) ?? {
    ...levels.find(({ name }) => name === 'standard')!,
    timeStep: step,
    iterations,
  };

/** As page code does: what is moved is put where it is to be at the end of the step that comes. */
function mover(nodes: Map<string, BodyNode>, { bodies }: CaseScene, timeStep: number): () => void {
  const moved = bodies
    .filter(({ path, turn }) => path ?? turn)
    .map(({ name, path, turn }) => ({ node: nodes.get(name)!, path, turn }));
  let steps = 0;
  return () => {
    steps++;
    const time = steps * timeStep;
    for (const { node, path, turn } of moved) {
      if (path) node.set('position', path(time));
      if (turn) node.set('orientation', turn(time));
    }
  };
}

/** As page code does: a force by where the body is, before each step. */
function puller(nodes: Map<string, BodyNode>, { bodies }: CaseScene): () => void {
  const pulled = bodies.flatMap(({ name, pull }) =>
    pull ? [{ node: nodes.get(name)!, pull }] : [],
  );
  return () => {
    for (const { node, pull } of pulled) node.set('forces', [pull(node.get('position') as Vec3)]);
  };
}

/** What a case may be about; any other problem means that the case was told wrongly. */
const HARD = ['mass-ratio', 'initial-overlap'];

/** Leaves a world's joints to Bullet's own rows. */
export const leaveJointsToBullet = (world: World): void => {
  world.registry.get(jointSolve).on = false;
};

/** One step after the other of Bullet alone: its own, with all that it does by itself, through none of our code. */
export function bulletAlone({ engine, bullet: { bullet }, timeStep }: World): () => void {
  engine.stages?.detach(engine.ammo.getPointer(bullet));
  return () => bullet.stepSimulation(timeStep, 0);
}

async function make(scene: CaseScene, setting: Setting, solve: boolean): Promise<Running> {
  const engine = await loadEngine();
  const world = new World({ level: levelOf(setting) });
  if (!solve) leaveJointsToBullet(world);
  const nodes = build(world, scene);
  world.start(engine);
  const wrong = world.problems.filter(({ code }) => !HARD.includes(code));
  if (wrong.length > 0) throw new Error(wrong.map(({ message }) => message).join('; '));
  const move = mover(nodes, scene, world.timeStep);
  const pull = puller(nodes, scene);
  const vector = (field: string) => (body: string) => nodes.get(body)!.get(field) as Vec3;
  /** From its origin to its centre of mass. */
  const arm = (body: string): Vec3 =>
    rotate(nodes.get(body)!.pose().q, nodes.get(body)!.get('centerOfMass') as Vec3);
  const centred = scene.bodies.every(({ offset }) => !offset);
  return {
    timeStep: world.timeStep,
    step: () => {
      move();
      pull();
      world.step();
    },
    position: centred ? vector('position') : (body) => add(vector('position')(body), arm(body)),
    orientation: (body) => nodes.get(body)!.pose().q,
    linearVelocity: centred
      ? vector('linearVelocity')
      : (body) =>
          add(vector('linearVelocity')(body), cross(vector('angularVelocity')(body), arm(body))),
    angularVelocity: vector('angularVelocity'),
    contacts: () => world.stats.contacts,
    effects: () => world.effects.filter(({ active }) => active).map(({ name }) => name),
    destroy: () => world.destroy(),
  };
}

const LEVELS: Setting[] = levels.map(({ name, timeStep, iterations }) => ({
  level: name,
  step: timeStep,
  iterations,
}));

export const ours: Engine = {
  id: 'ours',
  name: 'x3d-physics',
  says: 'Our five levels, and behind them a free sweep of step and iterations.',
  settings: [...LEVELS, ...sweep([5, 20, 50])],
  make: (scene, setting) => make(scene, setting, true),
};

/** For chains alone: what the direct solve of joints is measured by. */
export const iterated: Engine = {
  id: 'iterated',
  name: "Bullet's iterations alone",
  says: 'Our five levels without the direct solve of joints.',
  settings: LEVELS,
  make: (scene, setting) => make(scene, setting, false),
};
