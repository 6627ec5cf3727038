import initJolt from 'jolt-physics/wasm-compat';
import type { Jolt } from '../engines/jolt-joints.js';
import { JoltScene, MOVING } from '../engines/jolt-scene.js';
import type { CaseScene, Vec3 } from '../case.js';
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

type Shared = InstanceType<Jolt['SoftBodySharedSettings']>;

/** Scenes that the memory of one Jolt has room for: each takes ten megabytes and more. */
const TOGETHER = 6;

let scenes = 0;
let loading: Promise<Jolt> | undefined;

/** Many scenes are alive at once. */
function loaded(): Promise<Jolt> {
  if (scenes++ % TOGETHER === 0) loading = initJolt();
  return loading!;
}

/** What it falls on, as the other labs have it. */
const rigid = ({ gravity, ground, friction = 0 }: SoftScene): CaseScene => ({
  gravity: [0, -gravity, 0],
  bodies: ground ? [{ name: 'ground', fixed: true, shape: ground }] : [],
  contact: { friction, bounce: 0 },
});

function addVertices(jolt: Jolt, to: Shared, scene: SoftScene): void {
  const masses = massesOf(scene);
  const fixed = new Set(scene.fixed);
  scene.points.forEach((at, i) => {
    const vertex = new jolt.SoftBodySharedSettingsVertex();
    const [x, y, z] = fixed.has(i) ? heldAt(scene, i) : at;
    vertex.mPosition = new jolt.Float3(x, y, z);
    vertex.mInvMass = fixed.has(i) ? 0 : 1 / masses[i]!;
    to.mVertices.push_back(vertex);
    jolt.destroy(vertex);
  });
}

function addEdge(jolt: Jolt, to: Shared, { ends, stiffness, length }: Thread): void {
  const edge = new jolt.SoftBodySharedSettingsEdge(...ends, stiffness ? 1 / stiffness : 0);
  edge.mRestLength = length;
  to.mEdgeConstraints.push_back(edge);
  jolt.destroy(edge);
}

/** How far each point may be from the nearest fixed one, along the threads: what keeps its cloth from growing. */
function addReaches(jolt: Jolt, to: Shared, scene: SoftScene): void {
  const next: [number, number][][] = scene.points.map(() => []);
  for (const { ends, length } of threadsOf(scene)) {
    next[ends[0]]!.push([ends[1], length]);
    next[ends[1]]!.push([ends[0], length]);
  }
  const reach = scene.points.map((): [number, number] => [Infinity, -1]);
  const open = [...scene.fixed];
  for (const i of open) reach[i] = [0, i];
  for (let i = open.shift(); i !== undefined; i = open.shift())
    for (const [other, length] of next[i]!) {
      const far = reach[i]![0] + length;
      if (far >= reach[other]![0] - 1e-9) continue;
      reach[other] = [far, reach[i]![1]];
      open.push(other);
    }
  reach.forEach(([far, from], i) => {
    if (from < 0 || far === 0) return;
    const made = new jolt.SoftBodySharedSettingsLRA(from, i, far);
    to.mLRAConstraints.push_back(made);
    jolt.destroy(made);
  });
}

function addFaces(jolt: Jolt, to: Shared, scene: SoftScene): void {
  const index = trianglesOf(scene);
  for (let i = 0; i < index.length; i += 3) {
    const face = new jolt.SoftBodySharedSettingsFace(index[i]!, index[i + 1]!, index[i + 2]!, 0);
    to.AddFace(face);
    jolt.destroy(face);
  }
}

function sharedOf(jolt: Jolt, scene: SoftScene, { reaches }: SoftSetting): Shared {
  const shared = new jolt.SoftBodySharedSettings();
  addVertices(jolt, shared, scene);
  for (const thread of [...threadsOf(scene), ...diagonalsOf(scene)]) addEdge(jolt, shared, thread);
  if (reaches) addReaches(jolt, shared, scene);
  addFaces(jolt, shared, scene);
  shared.Optimize();
  return shared;
}

/** Faster than anything here goes, m/s. */
const FAST = 500;

/** The body: its place stays the origin, so that its points are where they say. */
function add(made: JoltScene, scene: SoftScene, setting: SoftSetting) {
  const { jolt } = made;
  const shared = sharedOf(jolt, scene, setting);
  const settings = made.own(
    new jolt.SoftBodyCreationSettings(
      shared,
      made.place([0, 0, 0]),
      made.own(new jolt.Quat(0, 0, 0, 1)),
      MOVING,
    ),
  );
  settings.mNumIterations = setting.iterations!;
  settings.mLinearDamping = scene.damping ?? 0;
  settings.mMaxLinearVelocity = FAST;
  settings.mFriction = scene.friction ?? 0;
  settings.mRestitution = 0;
  settings.mVertexRadius = scene.radius ?? 0;
  settings.mUpdatePosition = false;
  settings.mAllowSleeping = false;
  const bodies = made.system.GetBodyInterface();
  const body = bodies.CreateSoftBody(settings);
  bodies.AddBody(body.GetID(), jolt.EActivation_Activate);
  return body;
}

async function make(scene: SoftScene, setting: SoftSetting): Promise<SoftRunning> {
  const jolt = await loaded();
  const said = rigid(scene);
  const made = new JoltScene(jolt, said);
  for (const body of said.bodies) made.add(body);
  const body = add(made, scene, setting);
  const motion = jolt.castObject(body.GetMotionProperties(), jolt.SoftBodyMotionProperties);
  const vertices = motion.GetVertices();
  return {
    timeStep: setting.step,
    step: () => made.interface.Step(setting.step, 1),
    places: () =>
      scene.points.map((_, i): Vec3 => {
        const at = vertices.at(i).mPosition;
        return [at.GetX(), at.GetY(), at.GetZ()];
      }),
    free() {
      motion.SetLinearDamping(0);
      made.system.SetGravity(made.vec([0, 0, 0]));
    },
    destroy: () => made.destroy(),
  };
}

const FRAME = 1 / 60;

/**
 * An iteration of Jolt's soft bodies is a smaller step of them, and bodies near them are looked for once in a step. In parts of
 * less than some 1/5000 s nothing falls any more: what weight adds to a place is below single precision then.
 */
const sweep: readonly SoftSetting[] = [
  ...[2, 5, 10, 20, 40, 80].map((iterations) => ({ level: null, step: FRAME, iterations })),
  ...[5, 10, 20].map((iterations) => ({ level: null, step: FRAME / 4, iterations })),
];

/** Where nothing stretches and something is fixed, with points that are kept within their reach, too. */
function settings({ stretch, fixed }: SoftScene): SoftSetting[] {
  if (stretch || fixed.length === 0) return [...sweep];
  return [...sweep, ...sweep.map((setting) => ({ ...setting, reaches: true }))];
}

export const jolt: SoftEngine = {
  id: 'jolt',
  name: 'Jolt',
  package: 'jolt-physics',
  says: 'a SoftBody: an edge for each thread without compliance, or with that of its stiffness, diagonals for shear, each point kept within its reach of the nearest fixed one (LRA constraints) where nothing stretches; a load is the mass of a vertex, as rigid bodies can’t be tied to one; 5 iterations are its default',
  settings,
  make,
};
