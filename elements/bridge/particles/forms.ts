import type { Form } from './form.js';
import { lineForm } from './line-form.js';
import type { Look } from './look.js';
import { meshForm } from './mesh-form.js';
import { pointForm, squareForm } from './square-form.js';

/** By geometryType; GEOMETRY without one that has triangles is drawn as points. */
export function formOf(look: Look): Form {
  const { type, geometry } = look;
  if (type === 'POINT') return pointForm();
  if (type === 'LINE') return lineForm(look);
  if (type !== 'GEOMETRY') return squareForm(look);
  return geometry?._primType === 'TRIANGLES' ? meshForm(geometry, look.frame) : pointForm();
}
