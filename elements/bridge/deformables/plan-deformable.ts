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
  if (isIdentity(frame))
    return { ...(data && { geometry: data.geometry }), ...(data?.cells && cells(soft)) };
  const { geometry } = own ?? data ?? {};
  return {
    ...(geometry && { geometry: placed({ ...geometry }, frame, soft.units.length) }),
    ...(soft.type.fields.size && { size: noSize(soft), ...cells(soft) }),
  };
}

/** The core's own sheet would lie in the plane of the world: what it says goes into its geometry. */
function noSize(soft: Binding): unknown {
  const { size } = soft.type.fields;
  const asked = soft.authoredFields().size ?? size!.default;
  // What can't be read it tells of.
  return codecs[size!.type].accept(asked) === undefined ? asked : size!.default;
}

/** So that each edit of them is planned. */
const cells = (soft: Binding): Record<string, unknown> => ({
  subdivision: soft.authoredFields().subdivision ?? soft.type.fields.subdivision!.default,
});
