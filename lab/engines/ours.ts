import { jointSolve } from '../../physics-core/inside.js';
import { levels, loadEngine, World, type Level } from '../../physics-core/inside.js';
import type { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { CaseBody, CaseScene, Vec3 } from '../case.js';
import { sweep, type Engine, type Running, type Setting } from './engine.js';

function fieldsOf({
  name: _,
  shape,
  inertia,
  path: __,
  ...fields
}: CaseBody): Record<string, unknown> {
  return {
    ...fields,
    ...(shape && { geometry: [shape] }),
    ...(inertia && { inertia: inertia.flatMap((moment, i) => [0, 0, 0].with(i, moment)) }),
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
  const moved = bodies.flatMap(({ name, path }) => (path ? { node: nodes.get(name)!, path } : []));
  let steps = 0;
  return () => {
    steps++;
    for (const { node, path } of moved) node.set('position', path(steps * timeStep));
  };
}

/** What a case may be about; any other problem means that the case was told wrongly. */
const HARD = ['mass-ratio', 'initial-overlap'];

/** Leaves a world's joints to Bullet's own rows. */
export const leaveJointsToBullet = (world: World): void => {
  world.registry.get(jointSolve).on = false;
};

async function make(scene: CaseScene, setting: Setting, solve: boolean): Promise<Running> {
  const world = new World({ level: levelOf(setting) });
  if (!solve) leaveJointsToBullet(world);
  const nodes = build(world, scene);
  world.start(await loadEngine());
  const wrong = world.problems.filter(({ code }) => !HARD.includes(code));
  if (wrong.length > 0) throw new Error(wrong.map(({ message }) => message).join('; '));
  const move = mover(nodes, scene, world.timeStep);
  const vector = (field: string) => (body: string) => nodes.get(body)!.get(field) as Vec3;
  return {
    timeStep: world.timeStep,
    step: () => {
      move();
      world.step();
    },
    position: vector('position'),
    orientation: (body) => nodes.get(body)!.pose().q,
    linearVelocity: vector('linearVelocity'),
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
