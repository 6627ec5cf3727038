import { addBody, box, close, fact, height, sphere, world } from '../../helpers.js';
import { addSea, THICK } from './helpers.js';

/** Metres: what is asked of a depth. */
const EXACT = 1e-5;

/** How deep a solid lies of which a share is below: its cross-section by the height above its lowest point. */
function depthOf(share: number, tall: number, area: (y: number) => number): number {
  const steps = 20_000;
  const slice = tall / steps;
  const slices = Array.from({ length: steps }, (_, i) => area((i + 0.5) * slice) * slice);
  let left = share * slices.reduce((sum, each) => sum + each, 0);
  for (const [i, each] of slices.entries()) {
    if (left <= each) return (i + left / each) * slice;
    left -= each;
  }
  return tall;
}

const wedge = {
  type: 'IndexedFaceSet',
  convex: true,
  coord: [-1, -0.4, -1, 1, -0.4, -1, 1, -0.4, 1, -1, -0.4, 1, -0.5, 0.4, 0, 0.5, 0.4, 0],
  coordIndex: [0, 1, 2, 3, -1, 0, 4, 5, 1, -1, 2, 5, 4, 3, -1, 0, 3, 4, -1, 1, 5, 2, -1],
};

const both = [
  { ...box(2, 0.4, 1), translation: [0, 0, 0] },
  { ...box(1, 0.4, 1), translation: [0, 0.4, 0] },
];

interface Solid {
  geometry: unknown[];
  /** How far its lowest point is below its origin, how tall it is, and its cross-section above that point. */
  low: number;
  tall: number;
  area(y: number): number;
}

const SOLIDS: Record<string, Solid> = {
  'a box': { geometry: [box(2, 0.6, 1)], low: 0.3, tall: 0.6, area: () => 2 },
  'a ball': { geometry: [sphere(0.5)], low: 0.5, tall: 1, area: (y) => Math.PI * y * (1 - y) },
  'a cylinder': {
    geometry: [{ type: 'Cylinder', radius: 0.5, height: 0.4 }],
    low: 0.2,
    tall: 0.4,
    area: () => Math.PI / 4,
  },
  'a cylinder on its side': {
    geometry: [{ type: 'Cylinder', radius: 0.5, height: 2, rotation: [1, 0, 0, Math.PI / 2] }],
    low: 0.5,
    tall: 1,
    area: (y) => 4 * Math.sqrt(y * (1 - y)),
  },
  'a cone': {
    geometry: [{ type: 'Cone', bottomRadius: 0.5, height: 0.8 }],
    low: 0.4,
    tall: 0.8,
    area: (y) => Math.PI * (0.5 * (1 - y / 0.8)) ** 2,
  },
  'a frustum': {
    geometry: [{ type: 'Cone', bottomRadius: 0.6, topRadius: 0.3, height: 0.6 }],
    low: 0.3,
    tall: 0.6,
    // Drawn and collided with as one of 32 sides.
    area: (y) => 16 * Math.sin(Math.PI / 16) * (0.6 - 0.5 * y) ** 2,
  },
  'an ellipsoid': {
    geometry: [{ ...sphere(1), linear: [1, 0, 0, 0, 0.4, 0, 0, 0, 0.7] }],
    low: 0.4,
    tall: 0.8,
    area: (y) => Math.PI * 0.7 * (1 - (y / 0.4 - 1) ** 2),
  },
  'a hull': {
    geometry: [wedge],
    low: 0.4,
    tall: 0.8,
    area: (y) => 2 * (1 - y / 0.8) * (2 - y / 0.8),
  },
  'what is made of two': {
    geometry: both,
    low: 0.2,
    tall: 0.8,
    area: (y) => (y < 0.4 ? 2 : 1),
  },
};

const volumeOf = ({ tall, area }: Solid): number => {
  let sum = 0;
  for (let i = 0; i < 20_000; i++) sum += (area(((i + 0.5) * tall) / 20_000) * tall) / 20_000;
  return sum;
};

for (const [name, solid] of Object.entries(SOLIDS))
  fact(`${name} floats as deep as Archimedes says, at three densities`, async () => {
    for (const share of [0.2, 0.5, 0.85]) {
      const w = await world();
      addSea(w, THICK);
      // So heavy at its keel that it stands upright, over the middle of what it displaces.
      const body = addBody(w, {
        mass: 1000 * share * volumeOf(solid),
        centerOfMass: [0, -solid.low, 0],
        position: [0, 0.02, 0],
        geometry: solid.geometry,
      });
      w.advance(12);
      close(height(body), solid.low - depthOf(share, solid.tall, solid.area), EXACT);
    }
  });
