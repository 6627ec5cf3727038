// What pages have no words for comes with it.
import '../../physics-core/index.js';
import { createWorld } from '../../physics-core/create.js';
import { levels, type World } from '../../physics-core/inside.js';
import type { Vec3 } from '../case.js';
import { heldAt, trianglesOf, type SoftRunning, type SoftScene } from './scene.js';
import type { SoftEngine } from './engine.js';

/** What both kinds are told. */
const common = (scene: SoftScene) => ({
  mass: scene.mass,
  damping: scene.damping ?? 0,
  friction: scene.friction ?? 0,
  // What is held elsewhere than it is laid is tied there.
  fixedIndex: scene.spread ? [] : [...scene.fixed],
});

function laid(world: World, scene: SoftScene) {
  const { points, cells, radius = 0 } = scene;
  if (!cells)
    return world.add('Rope', { ...common(scene), points: points.map((at) => [...at]), radius });
  return world.add('Cloth', {
    ...common(scene),
    geometry: { type: 'IndexedTriangleSet', coord: points.flat(), index: trianglesOf(scene) },
    thickness: 2 * radius,
    stretchStiffness: scene.stretch ?? 0,
    shearStiffness: scene.shear ?? 0,
  });
}

/** Of a load, metres. */
const BALL = 0.1;

function addLoad(world: World, softBody: ReturnType<typeof laid>, scene: SoftScene): void {
  const { load, points } = scene;
  if (!load) return;
  const body = world.add('RigidBody', {
    mass: load.mass,
    position: points[load.point]!,
    geometry: [{ type: 'Sphere', radius: BALL }],
  });
  world.add('SoftBodyAttachment', { softBody, index: load.point, body });
}

async function make(
  scene: SoftScene,
  { level, step }: { level: string | null; step: number },
): Promise<SoftRunning> {
  const world = await createWorld({
    accuracy: level as 'standard',
    gravity: [0, -scene.gravity, 0],
    rest: 'never',
    console: false,
  });
  const soft = laid(world, scene);
  addLoad(world, soft, scene);
  if (scene.spread)
    for (const index of scene.fixed)
      world.add('SoftBodyAttachment', { softBody: soft, index, position: heldAt(scene, index) });
  if (scene.ground) world.add('RigidBody', { fixed: true, geometry: [scene.ground] });
  return {
    timeStep: step,
    step: () => world.step(),
    places: () => soft.get('positions') as Vec3[],
    free() {
      soft.set('damping', 0);
      world.settings.set('gravity', [0, 0, 0]);
    },
    destroy: () => world.destroy(),
  };
}

export const ours: SoftEngine = {
  id: 'ours',
  name: 'x3d-physics',
  says: 'Rope and Cloth as they come, at each level; a load is a body on a SoftBodyAttachment',
  settings: () =>
    levels.map(({ name, timeStep }) => ({ level: name, step: timeStep, iterations: null })),
  make,
};
