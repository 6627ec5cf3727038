import type { Ammo } from '../../physics-core/engine/ammo.js';
import { Owner } from '../../physics-core/engine/owner.js';
import { allOfAmmo } from '../engines/bullet-scene.js';
import type { Shape, Vec3 } from '../case.js';
import type { SoftEngine, SoftSetting } from './engine.js';
import {
  diagonalsOf,
  heldAt,
  massesOf,
  threadsOf,
  trianglesOf,
  type SoftRunning,
  type SoftScene,
  type Thread,
} from './scene.js';

type SoftBody = Ammo['btSoftBody']['prototype'];
type SoftWorld = Ammo['btSoftRigidDynamicsWorld']['prototype'];

const ALWAYS_AWAKE = 4;

/**
 * Of what a soft body lies on Bullet keeps a field of distances, in cells of a quarter of a unit, and no word of Ammo's makes
 * them finer: so a metre has so many units where something is to be met.
 */
const FINER = 20;

const unitOf = ({ ground }: SoftScene): number => (ground ? FINER : 1);

const times = ([x, y, z]: Vec3, factor: number): Vec3 => [factor * x, factor * y, factor * z];

function worldOf(ammo: Ammo, owner: Owner, scene: SoftScene): SoftWorld {
  const own = <T extends object>(made: T): T => owner.own(made);
  const configuration = own(new ammo.btSoftBodyRigidBodyCollisionConfiguration());
  const world = own(
    new ammo.btSoftRigidDynamicsWorld(
      own(new ammo.btCollisionDispatcher(configuration)),
      own(new ammo.btDbvtBroadphase()),
      own(new ammo.btSequentialImpulseConstraintSolver()),
      configuration,
      own(new ammo.btDefaultSoftBodySolver()),
    ),
  );
  const down = own(new ammo.btVector3(0, -scene.gravity * unitOf(scene), 0));
  world.setGravity(down);
  world.getWorldInfo().set_m_gravity(down);
  return world;
}

function shapeOf(ammo: Ammo, owner: Owner, shape: Shape) {
  if (shape.type === 'Sphere') return owner.own(new ammo.btSphereShape(FINER * shape.radius));
  if (shape.type !== 'Box') throw new Error(`no ${shape.type} here`);
  const [x, y, z] = times(shape.size, FINER / 2);
  return owner.own(new ammo.btBoxShape(owner.own(new ammo.btVector3(x, y, z))));
}

function addGround(ammo: Ammo, owner: Owner, world: SoftWorld, shape: Shape): void {
  const place = owner.own(new ammo.btTransform());
  place.setIdentity();
  const info = owner.own(
    new ammo.btRigidBodyConstructionInfo(
      0,
      owner.own(new ammo.btDefaultMotionState(place)),
      shapeOf(ammo, owner, shape),
      owner.own(new ammo.btVector3(0, 0, 0)),
    ),
  );
  const body = owner.own(new ammo.btRigidBody(info));
  // The friction of a soft body is multiplied by that of what it lies on.
  body.setFriction(1);
  world.addRigidBody(body);
}

/**
 * Bullet's links have no unit: `stiffness` is the share of what a link is too long that a round takes away. In steps of `dt`
 * with one round it is a spring of k N/m where that share is k dt² (1/m + 1/m'); more than all of it can't be.
 */
function stiffnessOf(
  { ends: [a, b], stiffness }: Thread,
  lightness: readonly number[],
  { step, iterations }: SoftSetting,
): number {
  if (stiffness === 0) return 1;
  return Math.min(1, (stiffness * step ** 2 * (lightness[a]! + lightness[b]!)) / iterations!);
}

function addThreads(body: SoftBody, scene: SoftScene, setting: SoftSetting): void {
  const fixed = new Set(scene.fixed);
  const lightness = massesOf(scene).map((mass, i) => (fixed.has(i) ? 0 : 1 / mass));
  const materials = new Map<number, Ammo['Material']['prototype']>();
  for (const thread of [...threadsOf(scene), ...diagonalsOf(scene)]) {
    const stiffness = stiffnessOf(thread, lightness, setting);
    const material = materials.get(stiffness) ?? body.appendMaterial();
    material.set_m_kLST(stiffness);
    materials.set(stiffness, material);
    body.appendLink(...thread.ends, material, false);
  }
}

/** Without the first point Bullet has no body to begin with. */
function bodyOf(ammo: Ammo, owner: Owner, world: SoftWorld, scene: SoftScene): SoftBody {
  const masses = massesOf(scene);
  const [first, ...others] = scene.points;
  const at = owner.own(new ammo.btVector3(...times(first!, unitOf(scene))));
  const body = new ammo.btSoftBody(world.getWorldInfo(), 1, at, [masses[0]!]);
  for (const [i, point] of others.entries()) {
    at.setValue(...times(point, unitOf(scene)));
    body.appendNode(at, masses[i + 1]!);
  }
  return body;
}

function set(
  ammo: Ammo,
  body: SoftBody,
  scene: SoftScene,
  { step, iterations }: SoftSetting,
): void {
  const config = body.get_m_cfg();
  config.set_viterations(0);
  config.set_piterations(iterations!);
  config.set_kDP((scene.damping ?? 0) * step);
  config.set_kDF(scene.friction ?? 0);
  // Against what is fixed, contacts are a tenth as hard by default.
  config.set_kKHR(1);
  const object = ammo.castObject(body, ammo.btCollisionObject);
  object.getCollisionShape().setMargin((scene.radius ?? 0.01) * unitOf(scene));
  body.setActivationState(ALWAYS_AWAKE);
}

/** A moment for Bullet to take the lengths of its links, seconds: it does so in its first step, from where its points are then. */
const MOMENT = 1e-6;

/** Takes what is fixed to where it is held. */
function spread(
  ammo: Ammo,
  owner: Owner,
  world: SoftWorld,
  body: SoftBody,
  scene: SoftScene,
): void {
  if (!scene.spread) return;
  world.stepSimulation(MOMENT, 0);
  const to = owner.own(new ammo.btVector3(0, 0, 0));
  for (const i of scene.fixed) {
    to.setValue(...times(heldAt(scene, i), unitOf(scene)));
    const node = body.get_m_nodes().at(i);
    node.set_m_x(to);
    node.set_m_q(to);
  }
}

async function make(scene: SoftScene, setting: SoftSetting): Promise<SoftRunning> {
  const ammo = await allOfAmmo();
  const owner = new Owner(ammo);
  const world = worldOf(ammo, owner, scene);
  if (scene.ground) addGround(ammo, owner, world, scene.ground);
  const body = bodyOf(ammo, owner, world, scene);
  addThreads(body, scene, setting);
  const index = trianglesOf(scene);
  for (let i = 0; i < index.length; i += 3)
    body.appendFace(index[i]!, index[i + 1]!, index[i + 2]!, body.get_m_materials().at(0));
  for (const i of scene.fixed) body.setMass(i, 0);
  set(ammo, body, scene, setting);
  world.addSoftBody(body, 1, -1);
  spread(ammo, owner, world, body, scene);
  const nodes = body.get_m_nodes();
  return {
    timeStep: setting.step,
    step: () => void world.stepSimulation(setting.step, 0),
    places: () =>
      scene.points.map((_, i): Vec3 => {
        const at = nodes.at(i).get_m_x();
        return times([at.x(), at.y(), at.z()], 1 / unitOf(scene));
      }),
    free() {
      body.get_m_cfg().set_kDP(0);
      const none = owner.own(new ammo.btVector3(0, 0, 0));
      world.setGravity(none);
      world.getWorldInfo().set_m_gravity(none);
    },
    destroy() {
      world.removeSoftBody(body);
      ammo.destroy(body);
      owner.dispose();
    },
  };
}

const FRAME = 1 / 60;

const sweep = (part: number, rounds: readonly number[]): SoftSetting[] =>
  rounds.map((iterations) => ({ level: null, step: FRAME / part, iterations }));

export const ammo: SoftEngine = {
  id: 'ammo',
  name: 'Ammo',
  package: 'ammojs-typed',
  says: 'a btSoftBody: a link for each thread, and diagonals for shear; where nothing stretches kLST is 1, else it is what one step makes of the stiffness; contacts as hard as they go (kKHR 1); a load is the mass of a node; 1 position iteration is its default',
  settings: () => [
    ...sweep(1, [1, 10, 100]),
    ...sweep(4, [1, 10, 100]),
    ...sweep(16, [1, 10, 100]),
    ...sweep(64, [1, 10]),
  ],
  make,
};
