import type { Owner } from '../engine/owner.js';
import { compose, invert } from '../base/math.js';
import type { ProblemReport } from '../base/problems.js';
import type { CollidablePart } from './collidable.js';
import { buildShape, type BtShape, type ShapeNote } from '../shapes/build.js';
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
export function shapeOf(body: BodyNode, owner: Owner): { shape: BtShape; parts: CollidablePart[] } {
  const { engine, registry } = body.world;
  const toCenter = invert(body.centerOfMass);
  const placed = body.parts.map((part) => ({
    ...part,
    pose: compose(toCenter, part.pose),
    exact: body.world.pairs.wantsTriangles(part.collidable),
  }));
  const notes = new Set<ShapeNote>();
  const { shape, made } = buildShape(placed, {
    ammo: engine.ammo,
    scratch: engine.scratch,
    owner,
    moving: body.movable,
    note: (note) => notes.add(note),
    allowMovingMeshes: () => body.world.bullet.allowMovingMeshes(),
  });
  if (notes.has('mesh')) registry.meshes.need(body, 'geometry');
  else registry.meshes.drop(body);
  tell(body, notes);
  const parts = body.parts;
  return { shape, parts: made.map(({ at, mesh }) => ({ ...parts[at]!, mesh })) };
}

function tell(body: BodyNode, notes: Set<ShapeNote>): void {
  for (const { says, ...report } of REPORTS) {
    if (notes.has(report.code)) body.report({ ...report, message: `${body.label}: ${says}` });
    else body.world.settle(body, 'geometry', report.code);
  }
}
