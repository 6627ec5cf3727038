import type { NodeData } from '../fact.js';

const appearance = (diffuseColor: number[]): NodeData => ({
  type: 'Appearance',
  material: { type: 'Material', diffuseColor },
});

/** What each field that is about how particles look is written as, and the event that follows. */
export const looks: Record<string, { written: unknown; event?: unknown }> = {
  appearance: { written: appearance([1, 0, 0]), event: appearance([0, 1, 0]) },
  castShadow: { written: false, event: true },
  color: { written: { type: 'Color', color: [1, 0, 0, 0, 0, 1] } },
  colorKey: { written: [0, 2] },
  geometry: { written: { type: 'Sphere', radius: 0.1 }, event: { type: 'Sphere', radius: 0.2 } },
  geometryType: { written: 'POINT' },
  texCoord: { written: { type: 'TextureCoordinate', point: [0, 0, 1, 0, 1, 1, 0, 1] } },
  texCoordKey: { written: [0, 2] },
};
