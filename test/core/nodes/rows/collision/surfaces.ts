import {
  addBody,
  above,
  below,
  box,
  claim,
  close,
  height,
  position,
  sphere,
  velocity,
  world,
  type Body,
  type Node,
} from '../../../helpers.js';
import type { Row } from '../row.js';

interface Lying {
  w: Awaited<ReturnType<typeof world>>;
  stone: Body;
  collection: Node;
}

/** A flat stone of 1 kg, 2 × 1 × 2 m, at rest on a slab, and a collection of both. */
async function lying(
  fields: Record<string, unknown> = {},
  stone: Record<string, unknown> = {},
): Promise<Lying> {
  const w = await world();
  const slab = w.add('CollidableShape', { shape: [box(200, 1, 200)] });
  const flat = w.add('CollidableShape', { shape: [stone.shape ?? box(2, 1, 2)] });
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  const { shape: _, ...others } = stone;
  const body = addBody(w, { position: [0, 0.5, 0], geometry: [flat], ...others });
  const collection = w.add('CollisionCollection', { collidables: [slab, flat], ...fields });
  w.advance(0.5);
  return { w, stone: body, collection };
}

/** Where a stone stops that is thrown flat at 4 m/s along (x, z). */
function thrown({ w, stone }: Lying, x: number, z: number): [number, number] {
  stone.event('position', [0, 0.5, 0]);
  stone.event('orientation', [0, 0, 1, 0]);
  stone.event('angularVelocity', [0, 0, 0]);
  stone.event('linearVelocity', [4 * x, 0, 4 * z]);
  w.advance(6);
  return [position(stone)[0], position(stone)[2]];
}

/** Way at a coefficient of friction from v m/s. */
const way = (mu: number, v = 4): number => (v * v) / (2 * mu * 9.8);

/** How deep the stone lies, metres; of what rests, 0.1 mm is always there. */
const depth = ({ stone }: Lying, half = 0.5): number => half - height(stone) - 1e-4;

/** Depth of a load as X3D's spring has it: its stiffness is 60 · error correction / softness. */
const sag = (force: number, softness: number, errorCorrection: number): number =>
  (force * softness) / (60 * errorCorrection);

export const surfaceRows: Row[] = [
  {
    field: 'frictionCoefficients',
    effect: 'contact surface',
    fact: 'with FRICTION_COEFFICIENT-2 each acts along its own direction, x and z on a floor; an oblique throw meets both',
    run: async () => {
      const scene = await lying({ frictionCoefficients: [0.4, 0.1] });
      close(thrown(scene, 0, 1), [0, way(0.4)], 0.05, 'm, z without the token');
      scene.collection.set('appliedParameters', ['FRICTION_COEFFICIENT-2']);
      close(thrown(scene, 1, 0), [way(0.4), 0], 0.05, 'm, x');
      close(thrown(scene, 0, 1), [0, way(0.1)], 0.05, 'm, z');
      const d = Math.SQRT1_2;
      close(thrown(scene, d, d), [way(0.4, 4 * d), way(0.1, 4 * d)], 0.05, 'm, oblique');
      scene.collection.set('appliedParameters', ['FRICTION_COEFFICIENT_2']);
      close(thrown(scene, 0, 1), [0, way(0.1)], 0.05, 'm, z, with an underscore');
    },
  },
  {
    field: 'surfaceSpeed',
    effect: 'contact surface',
    fact: 'a belt carries what lies on it: by friction until the speed is reached, and then at that speed',
    run: async () => {
      const scene = await lying({ surfaceSpeed: [1.5, -0.5] });
      const { w, stone, collection } = scene;
      w.advance(1);
      close(velocity(stone), [0, 0, 0], 1e-4, 'm/s, not applied');
      collection.set('appliedParameters', ['SPEED-1', 'SPEED_2']);
      w.advance(0.1);
      // Friction pulls along the belt, not by both rows at once.
      close(Math.hypot(...velocity(stone)), 0.5 * 9.8 * 0.1, 0.01, 'm/s after 0.1 s');
      w.advance(2);
      close(velocity(stone), [1.5, 0, -0.5], 1e-3, 'm/s, both');
      collection.set('appliedParameters', ['SPEED-1']);
      w.advance(2);
      close(velocity(stone), [1.5, 0, 0], 1e-3, 'm/s, the first');
      collection.set('surfaceSpeed', [-2, 7]);
      w.advance(2);
      close(velocity(stone), [-2, 0, 0], 1e-3, 'm/s, backwards');
    },
  },
  {
    field: 'slipFactors',
    effect: 'contact surface',
    fact: 'a load slides at factor × force along each direction, and stays where it slips in none',
    run: async () => {
      const scene = await lying({ slipFactors: [0.01, 0.2] });
      const { w, stone, collection } = scene;
      stone.set('forces', [[2, 0, 1]]);
      w.advance(1);
      close(velocity(stone), [0, 0, 0], 1e-4, 'm/s, not applied');
      collection.set('appliedParameters', ['SLIP-1', 'SLIP_2']);
      w.advance(3);
      close(velocity(stone), [0.02, 0, 0.2], 1e-4, 'm/s');
      collection.set('slipFactors', [0.05, -1]);
      w.advance(3);
      close(velocity(stone), [0.1, 0, 0], 1e-4, 'm/s, negative is none');
      collection.set('slipFactors', [1, 0]);
      w.advance(10);
      close(velocity(stone), [2, 0, 0], 2e-3, 'm/s, slippery');
    },
  },
  {
    field: 'softnessConstantForceMix',
    effect: 'contact surface',
    fact: 'a load F sinks in by F · softness / (60 · error correction), at any level and whatever its shape',
    run: async () => {
      for (const level of ['game', 'standard', 'fine']) {
        const flat = await lying({ softnessConstantForceMix: 0.02 }, { mass: 2 });
        claim(flat.w, 'approximated-field');
        flat.w.set('accuracy', level);
        flat.w.advance(1);
        below(Math.abs(depth(flat)), 1e-4, 'm, not applied');
        flat.collection.set('appliedParameters', ['CONSTANT_FORCE']);
        flat.w.advance(4);
        close(depth(flat), sag(19.6, 0.02, 0.8), 1e-4, `m, box at ${level}`);
        flat.collection.set('softnessConstantForceMix', 0.05);
        flat.w.advance(6);
        close(depth(flat), sag(19.6, 0.05, 0.8), 1e-4, `m, softer at ${level}`);
      }
      const round = await lying(
        { softnessConstantForceMix: 0.02, appliedParameters: ['CONSTANT_FORCE'] },
        { shape: sphere(0.5) },
      );
      claim(round.w, 'approximated-field');
      round.w.advance(4);
      close(depth(round), sag(9.8, 0.02, 0.8), 1e-4, 'm, ball');
    },
  },
  {
    field: 'softnessConstantForceMix',
    effect: 'contact surface',
    fact: 'at its upper end a load still sinks in as far, but never deeper than a quarter of the thinner body',
    run: async () => {
      for (const level of ['game', 'standard', 'fine']) {
        const soft = { softnessConstantForceMix: 0.5, appliedParameters: ['CONSTANT_FORCE'] };
        const { w, stone, collection } = await lying(soft);
        claim(w, 'approximated-field');
        w.set('accuracy', level);
        w.advance(8);
        close(0.5 - height(stone), sag(9.8, 0.5, 0.8), 1e-3, `m, at ${level}`);
        collection.set('softnessConstantForceMix', 1);
        w.advance(8);
        close(0.5 - height(stone), sag(9.8, 1, 0.8), 2e-3, `m, softest at ${level}`);
        // 4 kg would lie 0.82 m deep, and a fall of 2 m would take them right through.
        stone.set('mass', 4);
        stone.event('position', [0, 2.5, 0]);
        w.advance(4);
        close(0.5 - height(stone), 0.25, 1e-3, `m, a quarter at ${level}`);
      }
    },
  },
  {
    field: 'softnessErrorCorrection',
    effect: 'contact surface',
    fact: 'the share of an overlap that goes in a frame; with softness it sets how deep a load lies',
    run: async () => {
      const scene = await lying({ softnessErrorCorrection: 0.2 });
      const { w, stone, collection } = scene;
      w.set('gravity', [0, 0, 0]);
      const left = (frames: number): number => {
        stone.event('position', [0, 0.3, 0]);
        stone.event('linearVelocity', [0, 0, 0]);
        w.advance(frames / 60);
        return 0.5 - height(stone);
      };
      below(left(3), 0.03, 'm, not applied');
      collection.set('appliedParameters', ['ERROR_REDUCTION']);
      close([left(1), left(2), left(3)], [0.16, 0.128, 0.1024], 1e-3, 'm at 0.2');
      close(velocity(stone), [0, 0, 0], 1e-3, 'm/s: no velocity comes of it');
      collection.set('softnessErrorCorrection', 0.5);
      close([left(1), left(2)], [0.1, 0.05], 1e-3, 'm at 0.5');
      claim(w, 'approximated-field');
      collection.set('appliedParameters', ['ERROR_REDUCTION', 'CONSTANT_FORCE']);
      collection.set('softnessConstantForceMix', 0.02);
      w.set('gravity', [0, -9.8, 0]);
      w.advance(5);
      close(depth(scene), sag(9.8, 0.02, 0.5), 1e-4, 'm under load');
    },
  },
  {
    field: 'appliedParameters',
    fact: 'each token is taken with a hyphen or an underscore; USER_FRICTION means nothing here, an unknown one is told',
    run: async () => {
      const scene = await lying({ surfaceSpeed: [1, 1], frictionCoefficients: [0.3, 0.6] });
      const { w, stone, collection } = scene;
      for (const [tokens, speed] of [
        [['SPEED-1'], [1, 0, 0]],
        [['SPEED_2'], [0, 0, 1]],
        [['USER_FRICTION'], [0, 0, 0]],
        [
          ['SPEED_1', 'SPEED-2', 'FRICTION_COEFFICIENT-2'],
          [1, 0, 1],
        ],
      ] as const) {
        collection.set('appliedParameters', tokens);
        w.advance(1.5);
        close(velocity(stone), speed, 1e-3, `m/s with ${tokens.join()}`);
      }
      claim(w, 'bad-value');
      collection.set('appliedParameters', ['SPED-1']);
      w.advance(2);
      close(velocity(stone), [0, 0, 0], 1e-3, 'm/s with a word that is none');
      above(w.problems.filter(({ code }) => code === 'bad-value').length, 0);
    },
  },
];
