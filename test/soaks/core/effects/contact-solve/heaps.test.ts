import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import { hullCube } from '../../../../core/effects/contact-solve/scenes.js';
import { addBody, addFloor, box, fact, position, random, world } from '../../../../core/helpers.js';

// What is dropped into a room comes to rest by itself, also what rolls, rocks and spins.

/** A floor and four walls, so far from the middle, metres. */
function room(w: World, half: number): void {
  addFloor(w);
  for (const [x, z] of [
    [half, 0],
    [-half, 0],
    [0, half],
    [0, -half],
  ] as const)
    addBody(w, {
      fixed: true,
      position: [x, 3, z],
      geometry: [x === 0 ? box(2 * half + 1, 6, 1) : box(1, 6, 2 * half + 1)],
    });
}

const boxes = (r: () => number) => box(0.3 + 0.2 * r(), 0.3 + 0.2 * r(), 0.3 + 0.2 * r());
const hulls = () => ({ ...hullCube, coord: hullCube.coord.map((x) => 0.4 * x) });
const cones = () => ({ type: 'Cone', bottomRadius: 0.22, height: 0.4 });
const cylinders = () => ({ type: 'Cylinder', radius: 0.2, height: 0.4 });
const balls = () => ({ type: 'Sphere', radius: 0.2 });

const KINDS = [boxes, hulls, cones, cylinders, balls];
const mixed = (r: () => number) => KINDS[Math.floor(KINDS.length * r())]!(r);

/** Layers of four times as many as one of their sides, turned every way. */
function drop(w: World, count: number, geometry: (r: () => number) => object, seed: number) {
  const r = random(seed);
  const side = Math.ceil(Math.sqrt(count / 4));
  return Array.from({ length: count }, (_, i) => {
    const shape = geometry(r);
    const [x, y, z] = [r() - 0.5, r() - 0.5, r() - 0.5];
    const size = Math.hypot(x, y, z);
    return addBody(w, {
      position: [
        ((i % side) - (side - 1) / 2) * 0.88,
        0.5 + 0.88 * Math.floor(i / side ** 2),
        ((Math.floor(i / side) % side) - (side - 1) / 2) * 0.88,
      ],
      orientation: [x / size, y / size, z / size, 3 * r()],
      geometry: [shape],
    });
  });
}

const HEAPS = [
  ['100 boxes', 100, boxes, 11, 20],
  ['100 other boxes', 100, boxes, 101, 20],
  ['100 cubes of faces', 100, hulls, 202, 20],
  ['100 boxes of which one rocks', 100, boxes, 7, 20],
  ['100 cylinders', 100, cylinders, 3, 20],
  ['100 cones', 100, cones, 3, 20],
  ['100 of all kinds', 100, mixed, 5, 20],
  ['300 boxes', 300, boxes, 7, 40],
  ['300 cylinders', 300, cylinders, 7, 40],
] as const;

for (const [says, count, geometry, seed, seconds] of HEAPS)
  fact(`${says}, dropped into a room, are asleep within ${seconds} s`, async () => {
    const w = await world({ rest: 'auto', gravity: [0, -9.8, 0] });
    const half = count > 100 ? 5 : 3;
    room(w, half);
    const heap = drop(w, count, geometry, seed);
    w.advance(seconds);
    assert.equal(heap.filter(({ sleeping }) => !sleeping).length, 0);
  });

fact('100 cones, dropped into a room, stay in it', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
  room(w, 3);
  const heap = drop(w, 100, cones, 7);
  for (let i = 0; i < 6; i++) {
    w.advance(1);
    for (const cone of heap) {
      const [x, y, z] = position(cone);
      assert.ok(y > 0 && Math.abs(x) < 2.5 && Math.abs(z) < 2.5, `${position(cone)}`);
    }
  }
});
