import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  close,
  fact,
  position,
  world,
  type Body,
} from '../../helpers.js';

// What lies on a face, a line or an edge touches at the ends of what it lies on.

const G = 9.81;
const QUARTER = Math.PI / 2;

interface Point {
  position: [number, number, number];
  normal: [number, number, number];
  depth: number;
}

/** Where a body touches, as it hears of it when it first does so. */
async function touching(place: (w: World) => Body): Promise<Point[]> {
  const w = await world({ gravity: [0, -G, 0] });
  const body = place(w);
  let found: Point[] = [];
  body.on('collisionstart', (detail) => (found = (detail as { contacts: Point[] }).contacts));
  w.step();
  return found.sort((a, b) => a.position[0] - b.position[0] || a.position[2] - b.position[2]);
}

const cylinder = { type: 'Cylinder', radius: 0.3, height: 1 };

fact('a cylinder on its side touches a box at both ends of a line', async () => {
  const points = await touching((w) => {
    addFloor(w);
    return addBody(w, {
      position: [0, 0.2999, 0],
      orientation: [0, 0, 1, QUARTER],
      geometry: [cylinder],
    });
  });
  close(points.map(({ position }) => position).flat(), [-0.5, 0, 0, 0.5, 0, 0], 2e-4);
  for (const { normal, depth } of points) {
    close(normal, [0, 1, 0], 0);
    close(depth, 1e-4, 1e-6);
  }
});

fact('a cylinder that stands over the edge of a box touches as far as the box goes', async () => {
  const points = await touching((w) => {
    addFloor(w, 0, { position: [-30.1, -0.5, 0] });
    return addBody(w, { position: [-0.2, 0.4999, 0], geometry: [cylinder] });
  });
  close(Math.max(...points.map(({ position }) => position[0])), -0.1, 1e-6);
  close(Math.min(...points.map(({ position }) => position[0])), -0.5, 1e-6);
});

fact('a cone on its side touches a box at its tip and at its rim', async () => {
  const half = Math.atan(0.3);
  const slant = Math.hypot(1, 0.3);
  const points = await touching((w) => {
    addFloor(w);
    return addBody(w, {
      position: [-Math.cos(half) / 2, Math.sin(half) / 2 - 1e-4, 0],
      orientation: [0, 0, 1, -QUARTER - half],
      geometry: [{ type: 'Cone', bottomRadius: 0.3, height: 1 }],
    });
  });
  close(points.map(({ position }) => position).flat(), [-slant, 0, 0, 0, 0, 0], 2e-4);
});

fact('a cylinder along another touches it on a line, one across it in a point', async () => {
  const lower = { fixed: true, orientation: [0, 0, 1, QUARTER], geometry: [cylinder] };
  const along = await touching((w) => {
    addBody(w, lower);
    return addBody(w, {
      position: [0.2, 0.5999, 0],
      orientation: [0, 0, 1, QUARTER],
      geometry: [cylinder],
    });
  });
  close(along.map(({ position }) => position).flat(), [-0.3, 0.3, 0, 0.5, 0.3, 0], 2e-4);
  const across = await touching((w) => {
    addBody(w, lower);
    return addBody(w, {
      position: [0.2, 0.5999, 0.1],
      orientation: [1, 0, 0, QUARTER],
      geometry: [cylinder],
    });
  });
  close(across.map(({ position }) => position).flat(), [0.2, 0.3, 0], 2e-4);
  close(across[0]!.normal, [0, 1, 0], 1e-5);
});

fact('five cylinders stand on end', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  const pile = Array.from({ length: 5 }, (_, i) =>
    addBody(w, {
      position: [0, 0.5 + i, 0],
      geometry: [{ type: 'Cylinder', radius: 0.5, height: 1 }],
    }),
  );
  w.advance(10);
  pile.forEach((body, i) => {
    const [x, y, z] = position(body);
    below(Math.hypot(x, z), 1e-3, `way of cylinder ${i}`);
    close(y, 0.5 + i, 3e-3, `height of cylinder ${i}`);
  });
});
