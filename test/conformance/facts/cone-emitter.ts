import { holds, near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { directionFacts, emitterFacts, positionFact } from './emitter-facts.js';
import {
  chance,
  dot,
  ends,
  EXACT,
  MANY,
  mean,
  middle,
  SAMPLE,
  system,
  unit,
  velocities,
} from './particle-scenes.js';

/** All one way. */
const narrow: NodeData = { type: 'ConeEmitter', angle: 0, direction: [0, 1, 0] };

const AXIS = unit([1, 2, 2]);
const ANGLE = 0.5;

const angle: Fact = {
  field: 'angle',
  says: 'is the greatest one between direction and the way of a particle; all ways within it are as likely',
  open: 'particles are spread evenly over the solid angle of the cone',
  scene: system({ ...narrow, direction: [1, 2, 2], variation: 0, speed: 5, angle: ANGLE }, MANY),
  run: async (x) => {
    await x.advance(1);
    const all = (await velocities(x)).slice(0, SAMPLE).map(unit);
    const cosines = all.map((way) => dot(way, AXIS));
    const widest = Math.acos(Math.min(...cosines));
    const depth = 1 - Math.cos(ANGLE);
    const along = middle(all);
    const across = along.map((value, i) => value - dot(along, AXIS) * AXIS[i]!);
    return [
      holds('none is beyond it', widest < ANGLE + EXACT),
      near('the widest', widest, ANGLE, 0.01, 'rad'),
      // The share of the axis is even from cos of the angle to 1.
      near('mean cosine', mean(cosines), 1 - depth / 2, chance(depth / Math.sqrt(12)), ''),
      near('middle across the axis', across, [0, 0, 0], chance(Math.sqrt(depth / 2)), ''),
    ];
  },
};

const angleEvent: Fact = {
  field: 'angle',
  says: 'acts on those that are born after an event; with 0 all go one way',
  scene: system({ ...narrow, variation: 0, speed: 5, angle: 1 }),
  run: async (x) => {
    await x.advance(0.55);
    const wide = (await velocities(x)).map(([, y]) => y! / 5);
    await x.set('emitter', 'angle', 0);
    await x.advance(0.65);
    const after = (await velocities(x)).slice(-5).map(([, y]) => y! / 5);
    return [
      holds('they go apart', Math.min(...wide) < 0.99),
      near('cosines after it', ends(after), [1, 1], EXACT, ''),
    ];
  },
};

export const coneEmitter: Fact[] = [
  ...emitterFacts(narrow),
  positionFact(narrow),
  ...directionFacts(narrow),
  angle,
  angleEvent,
];
