import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boundsOf } from '../../../physics-core/shapes/bounds.js';
import type { Geometry } from '../../../physics-core/shapes/geometry.js';
import { boxAround } from '../../../physics-core/shapes/meshes.js';
import { tessellate } from '../../../physics-core/shapes/tessellate.js';

const SCALED = [0.3, 0, 0, 0, -2.7, 0, 0, 0, 0.3];
const whole: Geometry[] = [
  { type: 'Box', size: [0.1, 0.7, 3] },
  { type: 'Box', size: [0.1, 0.7, 3], linear: SCALED },
  { type: 'Sphere', radius: 0.37 },
  { type: 'Cylinder', radius: 0.37, height: 1.3, linear: SCALED },
  { type: 'Cone', bottomRadius: 0.37, height: 1.3, linear: SCALED },
];

for (const geometry of whole)
  test(`the box around a whole ${geometry.type}${geometry.linear ? ', scaled,' : ''} is that around its triangles, bit for bit`, () =>
    assert.deepEqual(boxAround(geometry), boundsOf(tessellate(geometry).points)));
