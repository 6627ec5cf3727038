import assert from 'node:assert/strict';
import { allTypes } from '../../../../physics-core/all-types.js';
import { addBody, box, close, height, sphere, world, type Body } from '../../helpers.js';
import { flat } from '../../effects/deformables/helpers.js';
import type { Row } from './row.js';

const VALUES: Record<string, unknown> = {
  metadata: { type: 'MetadataString' },
  bboxCenter: [1, 2, 3],
  bboxSize: [1, 2, 3],
  bboxDisplay: true,
  visible: false,
  description: 'for people',
};

/** What a node needs to stand there, and to leave the ball alone. */
function needs(type: string, ball: Body): Record<string, unknown> {
  if (type.endsWith('Joint')) return { body1: ball };
  if (type === 'Rope') return { points: [0, -100, 0, 1, -100, 0] };
  if (type === 'SoftBody')
    return { youngsModulus: 1e4, geometry: { ...box(1), translation: [0, -100, 0] } };
  if (type === 'Cloth') return { geometry: flat(1, 1, -100) };
  return type === 'WaterVolume' ? { position: [0, -100, 0] } : {};
}

/** Rows of the fields that a type shares with all others, or all bounded ones: they are kept, and nothing collides otherwise. */
export const commonRows = (type: string): Row[] =>
  Object.entries(allTypes[type]!.fields)
    .filter(([name, field]) => field.common || name === 'description')
    .map(([field, { default: initial }]): Row => ({
      field,
      fact: 'is kept and read back, and nothing moves otherwise',
      run: async () => {
        const w = await world();
        const shape = w.add('CollidableShape', { shape: [box(20, 1, 20)] });
        addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [shape] });
        const ball = addBody(w, { position: [0, 0.5, 0], geometry: [sphere(0.5)] });
        const found = [...w.nodes].find((node) => node.type.name === type);
        const node = found ?? w.add(type, needs(type, ball));
        assert.deepEqual(node.get(field), initial);
        node.set(field, VALUES[field]);
        assert.deepEqual(node.get(field), VALUES[field]);
        w.advance(0.5);
        close(height(ball), 0.5, 1e-3, 'm');
        node.unset(field);
        assert.deepEqual(node.get(field), initial);
      },
    }));
