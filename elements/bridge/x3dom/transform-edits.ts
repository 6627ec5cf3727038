import { codecs, type Units } from '../../../physics-core/inside.js';
import type { X3DNode, X3DOM } from './x3dom.js';

// Edits of Transforms, as x3dom tells of them: by attribute, ROUTE or setFieldValue.

/** Attributes that place a Transform, lowercase, and X3D's defaults: in force again when one is removed. */
export const PLACING: Record<string, string> = {
  translation: '0 0 0',
  rotation: '0 0 1 0',
  scale: '1 1 1',
  scaleorientation: '0 0 1 0',
  center: '0 0 0',
  matrix: '1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1',
};

const ROTATIONS = ['rotation', 'scaleorientation'];

/** Who hears of them. */
export interface TransformListener {
  /** `again`: an attribute says what it said already. */
  transformEdited(transform: Element, again: boolean): void;
  /** Those of the file of a Transform that a body moves; undefined for any other one. */
  unitsOfMoved(transform: Element): Units | undefined;
}

/** What x3dom was last told of each attribute. */
const told = new WeakMap<X3DNode, Map<string, string>>();

const toldOf = (node: X3DNode): Map<string, string> => {
  const texts = told.get(node) ?? new Map<string, string>();
  told.set(node, texts);
  return texts;
};

/** What an attribute said before its first change is what x3dom read when it made the node. */
export function noteRead(node: X3DNode, attribute: string, text: string): void {
  const texts = toldOf(node);
  if (!texts.has(attribute)) texts.set(attribute, text);
}

/** Whether x3dom was told the same before; it is told now. */
function saysAgain(node: X3DNode, attribute: string, text: string): boolean {
  const texts = toldOf(node);
  if (texts.get(attribute) === text) return true;
  texts.set(attribute, text);
  return false;
}

/** x3dom knows no UNIT and takes every angle for radians. */
function inRadians(attribute: string, text: string, { angle }: Units): string {
  if (angle === 1 || !ROTATIONS.includes(attribute)) return text;
  const rotation = codecs.SFRotation.parse(text) as number[] | undefined;
  return rotation ? [...rotation.slice(0, 3), rotation[3]! * angle].join(' ') : text;
}

export function watchTransforms(x: X3DOM, listener: TransformListener): void {
  let again = false;
  for (const name of ['Transform', 'MatrixTransform']) {
    const { prototype } = x.nodeTypes[name]!;
    const { fieldChanged, updateField } = prototype;
    prototype.updateField = function (this: X3DNode, attribute: string, text: string): void {
      const lower = attribute.toLowerCase();
      if (!this._xmlNode || !(lower in PLACING)) return updateField.call(this, attribute, text);
      const units = listener.unitsOfMoved(this._xmlNode);
      again = saysAgain(this, lower, text);
      // The body has moved on from there, and stays where it is.
      if (!again || !units)
        updateField.call(this, attribute, units ? inRadians(lower, text, units) : text);
      again = false;
    };
    prototype.fieldChanged = function (this: X3DNode, field: string): void {
      fieldChanged.call(this, field);
      if (this._xmlNode && field.toLowerCase() in PLACING)
        listener.transformEdited(this._xmlNode, again);
    };
  }
}
