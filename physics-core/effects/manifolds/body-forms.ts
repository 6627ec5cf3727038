import { compose, invert } from '../../base/math.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Form } from '../../shapes/forms/form.js';
import { Surface } from '../../shapes/surface/surface.js';
import { formOf, type Outline } from '../../shapes/outline.js';

/** The exact form of a part, and where it stands in the frame of its body's centre of mass. */
export interface PartForm {
  form: Form | undefined;
  /** Of what is made of triangles. */
  surface: Surface | undefined;
  turn: Float64Array;
  origin: Float64Array;
}

/** The forms of a body's solid parts, in Bullet's order. */
export interface BodyForms {
  readonly body: Body;
  /** What they were made of: a body whose shape changes has new ones. */
  parts: readonly CollidablePart[];
  forms: readonly PartForm[];
  /** Whether Bullet's own search leaves something to be wished for. */
  wanted: boolean;
}

const WANTED: readonly Outline['kind'][] = ['box', 'frustum', 'hull', 'triangles'];

/** A part whose contact points Bullet's own search does not find as they are. */
export const wanted = ({ solidParts }: Body): CollidablePart | undefined =>
  solidParts.find(({ outline }) => outline && WANTED.includes(outline.kind));

export function formsOf(body: Body): BodyForms {
  const parts = body.solidParts;
  const inverse = invert(body.centerOfMass);
  const forms = parts.map(({ outline, pose }) => {
    const { p, q } = compose(inverse, pose);
    const turn = new Float64Array(MATRIX);
    writeMatrix(turn, 0, q, 0);
    const form = outline && formOf(outline);
    const surface = outline?.kind === 'triangles' ? new Surface(outline.mesh) : undefined;
    return { form, surface, turn, origin: Float64Array.from(p) };
  });
  return { body, parts, forms, wanted: wanted(body) !== undefined };
}
