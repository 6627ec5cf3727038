import type { LevelName } from '../../../../physics-core/inside.js';
import { addBody, addJoint, sphere, world, type Body, type Hinge } from '../../helpers.js';

/** Eight spheres on ball joints, hanging 1 m apart from the world, the last one heavy. */
export async function chain(last: number, accuracy: LevelName = 'standard') {
  const w = await world({ accuracy });
  w.add('CollisionCollection', { collidables: '*', enabled: false });
  const links: Body[] = [];
  const joints: Hinge[] = [];
  for (let i = 0; i < 8; i++) {
    const above = links.at(-1);
    const link = addBody(w, {
      mass: i === 7 ? last : 0.1,
      geometry: [sphere(0.2)],
      position: [0, -1 - i, 0],
    });
    const ends = { ...(above && { body1: above }), body2: link, anchorPoint: [0, -0.5 - i, 0] };
    joints.push(addJoint(w, 'BallJoint', ends));
    links.push(link);
  }
  const gap = (): number => Math.max(...joints.map((joint) => joint.gap));
  return { w, links, gap };
}
