/** The X3D field types that physics nodes use, and the JavaScript values that stand for them. */
export type FieldType =
  | 'SFBool'
  | 'SFFloat'
  | 'SFInt32'
  | 'SFTime'
  | 'SFString'
  | 'SFVec2f'
  | 'SFVec3f'
  | 'SFRotation'
  | 'SFMatrix3f'
  | 'MFFloat'
  | 'MFInt32'
  | 'MFString'
  | 'MFVec3f'
  | 'SFNode'
  | 'MFNode';

export type Access = 'inputOutput' | 'initializeOnly' | 'inputOnly' | 'outputOnly';

export type Vec2 = [number, number];
export type Vec3 = [number, number, number];
/** Axis and angle, radians. */
export type Rotation = [number, number, number, number];

/** What a field holds: numbers, booleans, strings, arrays, or (SFNode, MFNode) nodes or plain data. */
export type Value = unknown;

/**
 * Powers of the units a `UNIT` statement may change (ISO/IEC 19775-1, 7.2.5.5).
 * Seconds can't be changed, so speeds are `{ length: 1 }` and accelerations too.
 */
export interface Dimension {
  angle?: number;
  length?: number;
  mass?: number;
  force?: number;
}
