import type { Field, NodeType } from '../../physics-core/inside.js';

// Values for every field of every node, by the tables.

export const kebab = (name: string): string =>
  name.replace(/[A-Z]/g, (letter, at: number) => (at ? '-' : '') + letter.toLowerCase());
export const holdsNodes = (field: Field): boolean => /Node$/.test(field.type);
export const attributeOf = (name: string, field: Field): string => (field.own ? kebab(name) : name);

/** Where not every value of the type will do: axes stand at right angles to each other, and there are few cells. */
const FITTING: Record<string, unknown> = {
  appliedParameters: ['SLIP-1'],
  axis1: [0, 0, 1],
  axis2: [0, -1, 0],
  motor1Axis: [0, 1, 0],
  motor2Axis: [-1, 0, 0],
  motor3Axis: [0, 0, -1],
  subdivision: [32, 16],
  fixedIndex: [0, 1],
};

/** A value other than the default, and within the range. */
export function sample(name: string, field: Field): unknown {
  if (name in FITTING) return FITTING[name];
  const [low, high] = field.range ?? [-Infinity, Infinity];
  const within = (value: number): number => Math.min(high, Math.max(low, value));
  const initial = field.default as number;
  const other =
    within(initial + 0.25) === initial ? within(initial - 0.25) : within(initial + 0.25);
  const samples: Record<string, unknown> = {
    SFBool: !field.default,
    SFFloat: other,
    SFTime: other,
    SFInt32: initial + 1,
    SFString: field.values?.find((value) => value && value !== field.default) ?? 'words',
    SFVec2f: [0.25, 0.5],
    SFVec3f: [0.5, 0.25, 0.125],
    SFRotation: [1, 0, 0, 0.5],
    SFMatrix3f: [1.5, 0, 0, 0, 1.5, 0, 0, 0, 1.25],
    MFFloat: [0.5, 1],
    MFInt32: [0, 1, -1],
    MFString: ['ALL'],
    MFVec3f: [
      [1, 2, 3],
      [4, 5, 6],
    ],
  };
  return samples[field.type];
}

export const written = (type: NodeType): [string, Field][] =>
  Object.entries(type.fields as Record<string, Field>).filter(
    ([, field]) =>
      !holdsNodes(field) && field.access !== 'outputOnly' && field.access !== 'inputOnly',
  );
