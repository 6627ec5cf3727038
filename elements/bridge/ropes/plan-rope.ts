import { codecs, type World } from '../../../physics-core/inside.js';
import { isIdentity } from '../geometry/matrix.js';
import { takeShapes } from '../matter/taken.js';
import type { Binding } from '../nodes/binding.js';
import { collectionNode, type Plan } from '../plans/plan.js';
import { showRope } from './drawing/ropes-drawn.js';
import { frameOf, inWorld } from '../matter/frame.js';
import { lineOf, type LineData } from './line-of.js';

export function planRope(rope: Binding, world: World): Plan | undefined {
  const { data, shape } = lineOf(rope);
  // Without what it stands for, nobody knows where it is.
  if (rope.waiting.has('for')) return undefined;
  const shapes = shape ? [shape] : [];
  rope.onnode = () => {
    takeShapes(rope, rope.node ? shapes : []);
    void showRope(rope, shapes);
  };
  return { world, collection: collectionNode(rope), relations: laid(rope, data) };
}

/** What it says in its own frame as it is in the world. */
function laid(rope: Binding, line: LineData | undefined): Record<string, unknown> {
  const relations: Record<string, unknown> = {};
  const frame = frameOf(rope);
  const { length } = rope.units;
  const points = codecs.MFVec3f.accept(rope.authoredFields().points ?? []) as
    number[][] | undefined;
  if (line) relations.geometry = { ...line, coord: inWorld(frame, line.coord, length) };
  if (!isIdentity(frame)) relations.points = inWorld(frame, (points ?? []).flat(), length);
  return relations;
}
