import { compose, invert } from '../../base/math.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Form } from '../../shapes/forms/form.js';
import { meshes } from '../../shapes/meshes.js';
import type { Surface } from '../../shapes/surface/surface.js';
import { wanted } from './effects.js';
import { PlacedForm } from './placed-form.js';
import { formOf } from '../../shapes/outline.js';

/** The exact form of a part, and where it stands in the frame of its body's centre of mass. */
export interface PartForm {
  form: Form | undefined;
  /** Of what is made of triangles. */
  surface: Surface | undefined;
  turn: Float64Array;
  origin: Float64Array;
  /** Where it stands in the world, and the search for which that holds. */
  placed: PlacedForm;
  search: number;
}

/** The forms of a body's solid parts, in Bullet's order. */
export interface BodyForms {
  readonly body: Body;
  /** What they were made of: a body whose shape changes has new ones. */
  parts: readonly CollidablePart[];
  forms: readonly PartForm[];
  /** Whether Bullet's own search leaves something to be wished for. */
  wanted: boolean;
  /** Whether it is boxes alone, whose points Bullet finds nearly as they are. */
  boxes: boolean;
}

const isBoxes = ({ solidParts }: Body): boolean =>
  solidParts.every(({ outline }) => outline?.kind === 'box');

/** Whether any pair of it may be one whose points are worked out here. */
export const concerns = (body: Body): boolean => wanted(body) !== undefined || isBoxes(body);

export function formsOf(body: Body): BodyForms {
  const parts = body.solidParts;
  const inverse = invert(body.centerOfMass);
  const forms = parts.map(({ outline, pose }) => {
    const { p, q } = compose(inverse, pose);
    const turn = new Float64Array(MATRIX);
    writeMatrix(turn, 0, q, 0);
    const form = outline && formOf(outline);
    const surface = outline?.kind === 'triangles' ? meshes.code.surfaceOf(outline.mesh) : undefined;
    const placed = new PlacedForm();
    if (form) placed.form = form;
    return { form, surface, turn, origin: Float64Array.from(p), placed, search: 0 };
  });
  return { body, parts, forms, wanted: wanted(body) !== undefined, boxes: isBoxes(body) };
}
