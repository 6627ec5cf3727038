import { codecs, type World } from '../../../physics-core/inside.js';
import { placed } from '../document/geometry-reader.js';
import { isIdentity } from '../geometry/matrix.js';
import { frameOf } from '../matter/frame.js';
import { takeShapes } from '../matter/taken.js';
import type { Binding } from '../nodes/binding.js';
import { collectionNode, type Plan } from '../plans/plan.js';
import { showDeformable } from './drawing/deformables-drawn.js';
import { surfaceOf, type Surface } from './surface-of.js';

export function planDeformable(soft: Binding, world: World): Plan | undefined {
  const surface = surfaceOf(soft);
  // Without what it stands for, nobody knows where it is.
  if (soft.waiting.has('for')) return undefined;
  const shapes = surface.shape ? [surface.shape] : [];
  soft.onnode = () => {
    takeShapes(soft, soft.node ? shapes : []);
    void showDeformable(soft, shapes, surface.own ?? surface.data);
  };
  return { world, collection: collectionNode(soft), relations: laid(soft, surface) };
}

/** What it says in its own frame as it is in the world, of which alone the core knows. */
function laid(soft: Binding, { own, data }: Surface): Record<string, unknown> {
  const frame = frameOf(soft);
  const isMoved = !isIdentity(frame);
  const isSheet = own !== undefined && !isMoved;
  const { geometry } = (isSheet ? data : (own ?? data)) ?? {};
  const relations = soft.type.fields.size ? words(soft, isSheet) : {};
  if (!geometry) return relations;
  relations.geometry = isMoved ? placed({ ...geometry }, frame, soft.units.length) : geometry;
  return relations;
}

/** Of a Cloth, so that each edit of them is planned: the core's own sheet lies in the world. What can't be read it tells of. */
function words(soft: Binding, isSheet: boolean): Record<string, unknown> {
  const asked = soft.authoredFields();
  const { size, subdivision } = soft.type.fields;
  const given = asked.size ?? size!.default;
  const isRead = codecs[size!.type].accept(given) !== undefined;
  return {
    size: isSheet || !isRead ? given : size!.default,
    subdivision: asked.subdivision ?? subdivision!.default,
  };
}
