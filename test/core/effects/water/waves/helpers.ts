import type { WaveField } from '../../../../../physics-core/effects/water/waves/field.js';
import { waves } from '../../../../../physics-core/effects/water/effects.js';
import type { WaveSurface } from '../../../../../physics-core/effects/water/waves/surface.js';
import type { WaterVolumeNode } from '../../../../../physics-core/water.js';
import type { World } from '../../../../../physics-core/inside.js';
import type { Node } from '../../../helpers.js';
import { steppingOf } from '../../../thread/at-once.js';

export const G = 9.8;
const POOL = { size: [20, 2, 20], position: [0, -1, 0], waves: true, waveDamping: 0 };
export const CALM = { dragCoefficient: 0, liftCoefficient: 0, damping: 0 };
export const LEVELS = ['game', 'standard', 'fine', 'precise', 'reference'];

export const addPool = (w: World, fields: Record<string, unknown> = {}): Node =>
  w.add('WaterVolume', { ...POOL, ...fields });

/** The surface of a volume where its steps are taken. */
export function surfaceOf(w: World, pool: Node) {
  const stepping = steppingOf(w);
  const source = [...stepping.nodes].find(({ id }) => id === pool.id) as WaterVolumeNode;
  return stepping.registry.find(waves)!.of(source) as WaveSurface;
}
export const fieldOf = (w: World, pool: Node): WaveField => surfaceOf(w, pool).field;

export const sum = (all: Float64Array): number => all.reduce((total, each) => total + each, 0);
const squares = (all: Float64Array): number => all.reduce((total, each) => total + each * each, 0);

/** Of what is above the still water, m³. */
export const volumeOf = (field: WaveField): number => field.cellArea * sum(field.heights);

/** Of a surface of water, joules. */
export function energyOf({
  heights,
  alongWidth,
  alongLength,
  conditions,
  cellArea,
}: WaveField): number {
  const flows = squares(alongWidth) + squares(alongLength);
  return 500 * cellArea * (G * squares(heights) + flows / conditions.depth);
}
