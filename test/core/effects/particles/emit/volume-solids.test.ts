import assert from 'node:assert/strict';
import { volumeEmitter } from '../../../../../physics-core/effects/particles/emit/volume-emitter.js';
import type { Mesh } from '../../../../../physics-core/shapes/geometry.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import { below, fact } from '../../../helpers.js';
import {
  birthsOf,
  blockLaw,
  blockMesh,
  follow,
  insideOut,
  joined,
  mixOf,
  prism,
  within,
  type Block,
} from './laws.js';

const filled = (mesh: Mesh): ReturnType<typeof volumeEmitter> =>
  volumeEmitter({ mesh, internal: true, direction: [0, 1, 0], speed: 1, variation: 0 });

const OUTER: Block = [
  [-1, -1, -1],
  [1, 1, 2],
];
const HOLLOW: Block = [
  [-0.5, -0.9, 0],
  [0.9, 0.3, 1.5],
];
const [whole, wholeLaw] = blockLaw(OUTER);
const [hole, holeLaw] = blockLaw(HOLLOW);
const isIn = ([x, y, z]: Float64Array, [least, most]: Block): boolean =>
  [x!, y!, z!].every((value, i) => value > least[i]! && value < most[i]!);

fact('a solid may be hollow: nothing is born in the hollow, and the rest is filled evenly', () => {
  const mesh = joined(blockMesh(OUTER), insideOut(blockMesh(HOLLOW)));
  const births = birthsOf(filled(mesh));
  follow(
    births,
    mixOf([
      [whole, wholeLaw],
      [-hole, holeLaw],
    ]),
  );
  assert.equal(
    births.most((b) => (isIn(b, HOLLOW) ? 1 : 0)),
    0,
  );
});

fact('parts that overlap are filled as one, and no place of them is twice as likely', () => {
  const [a, b, both]: Block[] = [
    [
      [0, 0, 0],
      [2, 1, 1],
    ],
    [
      [1, 0.5, 0.5],
      [3, 2, 2],
    ],
    [
      [1, 0.5, 0.5],
      [2, 1, 1],
    ],
  ] as Block[];
  const law = blockLaw(both!);
  const births = birthsOf(filled(joined(blockMesh(a!), blockMesh(b!))));
  follow(births, mixOf([blockLaw(a!), blockLaw(b!), [-law[0], law[1]]]));
});

fact('a cylinder is filled evenly: the mean square of the radius is half of its own', () => {
  const mesh = tessellate({ type: 'Cylinder', radius: 2, height: 1 });
  const births = birthsOf(filled(mesh), 50_000);
  // A polygon of 32 sides in the circle: 2/3 + cos(2π/32)/3 of what the circle has.
  const law = 2 * (2 / 3 + Math.cos(Math.PI / 16) / 3);
  within(
    births.mean(([x, , z]) => x! * x! + z! * z!),
    law,
    0.01 * law,
  );
  within(
    births.mean(([, y]) => y! * y!),
    1 / 12,
    0.01 / 12,
  );
});

fact('a ball is filled evenly: the mean square from its middle is 3/5 of R²', () => {
  const births = birthsOf(filled(tessellate({ type: 'Sphere', radius: 3 })), 20_000);
  const square = births.mean(([x, y, z]) => x! * x! + y! * y! + z! * z!);
  // The mesh's own is 0.7 % smaller.
  within(square, 5.4, 0.054);
  for (let i = 0; i < 3; i++)
    within(
      births.mean((b) => b[i]!),
      0,
      0.03,
    );
});

fact('a star of many points is filled in its points and not between them', () => {
  const star = Array.from({ length: 22 }, (_, i): [number, number] => {
    const radius = i % 2 === 0 ? 1 : 0.3;
    return [radius * Math.cos((i * Math.PI) / 11), radius * Math.sin((i * Math.PI) / 11)];
  });
  const births = birthsOf(filled(prism(star, 1)), 30_000);
  // Twenty-two triangles with the middle: the mean square of each is a sixth of those of its sides, and of their product.
  const law = (1 + 0.09 + 0.3 * Math.cos(Math.PI / 11)) / 6;
  within(
    births.mean(([x, y]) => x! * x! + y! * y!),
    law,
    0.01 * law,
  );
  // In its own frame, each birth is on the inner side of the line from tip to notch.
  const out = ([x, y]: Float64Array): number => {
    const turn = Math.abs(Math.atan2(y!, x!));
    const part = Math.abs(turn - (2 * Math.PI * Math.round((turn * 11) / (2 * Math.PI))) / 11);
    const [nx, ny] = [0.3 * Math.cos(Math.PI / 11), 0.3 * Math.sin(Math.PI / 11)];
    const radius = Math.hypot(x!, y!);
    const [px, py] = [radius * Math.cos(part), radius * Math.sin(part)];
    return (nx - 1) * py - ny * (px - 1);
  };
  below(
    births.most((b) => -out(b)),
    1e-12,
  );
});
