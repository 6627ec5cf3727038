import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  close,
  fact,
  height,
  position,
  spin,
  velocity,
  world,
} from '../../../../core/helpers.js';

// A flat mesh is as flat as a box: nothing trips over the edges within it.

const G = 9.81;

/** A square of triangles, `cells` by `cells` of a metre each. */
function grid(cells: number) {
  const coord: number[] = [];
  const index: number[] = [];
  const row = cells + 1;
  for (let i = 0; i < row; i++)
    for (let j = 0; j < row; j++) coord.push(i - cells / 2, 0, j - cells / 2);
  for (let i = 0; i < cells; i++)
    for (let j = 0; j < cells; j++) {
      const at = i * row + j;
      index.push(at, at + 1, at + row + 1, at, at + row + 1, at + row);
    }
  return { type: 'IndexedTriangleSet', coord, index };
}

const heights = {
  type: 'ElevationGrid',
  xDimension: 41,
  zDimension: 41,
  height: Array(1681).fill(0),
};

const onMesh = (w: World, geometry: object = grid(40)): void =>
  void addBody(w, { fixed: true, geometry: [geometry] });

const LEVELS = ['game', 'standard'] as const;
const cylinder = { type: 'Cylinder', radius: 0.3, height: 0.6 };

for (const accuracy of LEVELS)
  fact(`what slides over a flat mesh goes as far as friction lets it at ${accuracy}`, async () => {
    for (const geometry of [box(0.6), cylinder]) {
      const w = await world({ gravity: [0, -G, 0], accuracy });
      onMesh(w);
      const body = addBody(w, {
        position: [0.1, 0.2999, 0.2],
        linearVelocity: [4, 0, 1.7],
        geometry: [geometry],
      });
      let off = 0;
      for (let i = 0; i < 20; i++) {
        w.advance(0.1);
        off = Math.max(off, Math.abs(height(body) - 0.3));
      }
      // v² / (2 μ g) with μ = 0.5
      const way = (4 ** 2 + 1.7 ** 2) / G;
      const [x, , z] = position(body);
      close(Math.hypot(x - 0.1, z - 0.2), way, 0.004, `way of a ${geometry.type}`);
      below(off, 2e-4, `height of a ${geometry.type}`);
      below(Math.hypot(...spin(body)), 1e-4, `spin of a ${geometry.type}`);
    }
  });

for (const accuracy of LEVELS)
  fact(
    `what rolls over a flat mesh or a field of heights keeps its speed at ${accuracy}`,
    async () => {
      const fields = { ...heights, translation: [-20, 0, -20] };
      for (const mesh of [grid(40), fields])
        for (const [geometry, orientation] of [
          [{ type: 'Sphere', radius: 0.3 }, [0, 0, 1, 0]],
          [cylinder, [0, 0, 1, Math.PI / 2]],
        ] as const) {
          const w = await world({ gravity: [0, -G, 0], accuracy });
          onMesh(w, mesh);
          const body = addBody(w, {
            position: [0.13, 0.3, -9],
            orientation,
            linearVelocity: [0, 0, 1],
            angularVelocity: [1 / 0.3, 0, 0],
            geometry: [geometry],
          });
          w.advance(15);
          const what = `${geometry.type} on ${mesh.type}`;
          close(velocity(body), [0, 0, 1], 2e-3, `velocity, ${what}`);
          close(height(body), 0.3, 2e-4, `height, ${what}`);
        }
    },
  );
