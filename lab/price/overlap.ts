import type { CaseBody, CaseScene, Sight, Vec3 } from '../case.js';
import { poseOf } from '../engines/bodies.js';
import { BulletScene, type Ways } from '../engines/bullet-scene.js';
import { bulletJoint } from '../engines/ammo.js';
import { plansOf } from '../engines/joints.js';
import { rotationOf } from '../../physics-core/base/math.js';

// How deep bodies overlap is read from their places alone, by one search for all engines: each has its own of what is
// near enough to be called a contact.

/** Seconds: nothing moves before its contacts are found. */
const AT_ONCE = 1e-6;

/** Metres: by as much a hull is too thick, and other corners are round. Bullet's own would be 4 cm. */
const SKIN = 5e-4;

const isHollow = ({ shape, fixed }: CaseBody): boolean =>
  shape?.type === 'ElevationGrid' || (shape?.type === 'IndexedTriangleSet' && fixed === true);

const ways: Ways = {
  shape(scene, body) {
    const made = scene.primitive(body.shape!, !body.fixed);
    if (!isHollow(body)) made.setMargin(SKIN);
    return made;
  },
  moments: (): Vec3 => [1, 1, 1],
  material: (contact) => contact,
  damping: () => ({ linear: 0, angular: 0 }),
  joint: (scene, plan) => bulletJoint(scene, plan, AT_ONCE),
};

/** Where an engine has it now, at rest. */
function placed(body: CaseBody, sight: Sight): CaseBody {
  const { name, shape, fixed, turn, path } = body;
  const at = turn ?? path ?? !fixed;
  return {
    name,
    ...(shape && { shape }),
    ...(fixed && { fixed }),
    position: at ? sight.position(name) : poseOf(body).p,
    orientation: at ? rotationOf(sight.orientation(name)) : (body.orientation ?? [0, 0, 1, 0]),
  };
}

/** Metres of the deepest overlap of bodies that may touch. */
export async function overlapIn(scene: CaseScene, sight: Sight): Promise<number> {
  const bodies = scene.bodies.map((body) => placed(body, sight));
  const still: CaseScene = { gravity: [0, 0, 0], bodies, contact: { bounce: 0, friction: 0 } };
  const made = await BulletScene.make(still, ways, plansOf(scene));
  made.world.stepSimulation(AT_ONCE, 0);
  const deepest = Math.max(0, ...made.distances().map((distance) => -distance));
  made.destroy();
  return deepest;
}
