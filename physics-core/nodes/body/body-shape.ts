import { meshShapes } from '../../effects/contacts/mesh-shapes.js';
import type { Owner } from '../../engine/owner.js';
import { compose, invert } from '../../base/math.js';
import type { ProblemReport } from '../../base/problems.js';
import type { NodePart } from '../collision/collidable.js';
import { buildShape, type BtShape, type ShapeNote } from '../../shapes/build.js';
import type { BodyNode } from './body.js';

/** What authors are told where a shape comes out different from what they wrote. */
const REPORTS: readonly (Omit<ProblemReport, 'message'> & { code: ShapeNote; says: string })[] = [
  {
    code: 'concave-dynamic',
    severity: 'info',
    attribute: 'geometry',
    used: 'convex hull',
    says: "a moving body can't collide as a hollow mesh; its convex hull is used",
  },
  {
    code: 'zero-volume',
    severity: 'warning',
    attribute: 'geometry',
    used: 'least thickness',
    says: 'a geometry without volume (a size of zero, no points or faces) hardly collides; the least thickness is used',
  },
];

/** The shape of a body, in the frame of its centre of mass. What it is made of goes to `owner`. */
export function shapeOf(body: BodyNode, owner: Owner): { shape: BtShape; parts: NodePart[] } {
  const { engine, registry: effects, bullet, pairs } = body.world;
  const toCenter = invert(body.centerOfMass);
  const placed = body.parts.map((part) => ({
    ...part,
    pose: compose(toCenter, part.pose),
    exact: pairs.wantsTriangles(part.collidable),
  }));
  const notes = new Set<ShapeNote>();
  const { shape, made } = buildShape(placed, {
    ammo: engine.ammo,
    scratch: engine.scratch,
    owner,
    moving: body.movable,
    note: (note) => notes.add(note),
    allowMovingMeshes: () => bullet.allowMovingMeshes(),
  });
  if (notes.has('mesh')) effects.get(meshShapes).need(body, 'geometry');
  else effects.find(meshShapes)?.release(body);
  tell(body, notes);
  const parts = body.parts;
  return {
    shape,
    parts: made.map(({ at, outline }) => ({
      ...parts[at]!,
      outline,
      mesh: outline.kind === 'triangles',
    })),
  };
}

function tell(body: BodyNode, notes: Set<ShapeNote>): void {
  for (const { says, ...report } of REPORTS) {
    body.reportWhile(notes.has(report.code), { ...report, message: `${body.label}: ${says}` });
  }
}
