import type { NodeData } from '../conformance/fact.js';
import { OFF, ON, POINTS, SHARES, TURNS, type Edit } from './edit.js';

/** Far from everything else: nothing floats in it. */
export const waterScene = (): NodeData[] => [
  { type: 'WaterVolume', DEF: 'water', position: [0, -500, 0] },
];

/** Whatever sleeps in its world is asked whether it still lies as it would. */
const ASKED = ['?stone~awake'];

const edit = (values: Edit['values']): Edit => ({
  values,
  changes: ASKED,
  stays: ASKED,
});

const moving = (values: Edit['values']): Edit => ({ ...edit(values), given: { waves: true } });

export const waterEdits: Record<string, Edit> = {
  enabled: edit(OFF),
  position: {
    ...edit([
      [0, -400, 0],
      [10, -400, 0],
    ]),
    stays: ['.position', ...ASKED],
  },
  orientation: edit(TURNS),
  size: edit([
    [1, 2, 3],
    [3, 2, 1],
  ]),
  density: edit([1025, 800]),
  dragCoefficient: edit(SHARES),
  liftCoefficient: edit(SHARES),
  damping: edit(SHARES),
  addedMass: edit(SHARES),
  flow: edit(POINTS),
  waves: { ...edit(ON), changes: ['~effects', ...ASKED] },
  subdivision: moving([[32, 16], [8]]),
  edges: moving(['OPEN', 'REFLECTING']),
  waveDamping: moving(SHARES),
};
