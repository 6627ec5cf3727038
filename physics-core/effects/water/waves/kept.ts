import { doublesOf, pack } from '../../../base/packed.js';
import { Stand } from './stand.js';
import type { WaveField } from './field.js';

export type KeptStand = Omit<Stand, 'stirs' | 'goOn' | 'begin' | 'take' | 'isStill'>;

/** A surface as a snapshot has it. */
export interface KeptSurface {
  begins: boolean;
  asleep: boolean;
  looked: number;
  /** Heights and flows as text; where it sleeps its level. */
  field: number | readonly [heights: string, alongWidth: string, alongLength: string];
  /** By the numbers of bodies. */
  stands: readonly (readonly [body: number, stand: KeptStand])[];
}

export function keepField(field: WaveField, asleep: boolean): KeptSurface['field'] {
  if (asleep) return field.heights[0]!;
  return [pack(field.heights), pack(field.alongWidth), pack(field.alongLength)];
}

export function restoreField(field: WaveField, kept: KeptSurface['field']): void {
  if (typeof kept === 'number') return field.calm(kept);
  field.heights.set(doublesOf(kept[0]));
  field.alongWidth.set(doublesOf(kept[1]));
  field.alongLength.set(doublesOf(kept[2]));
  field.crest = field.heights.reduce((most, height) => Math.max(most, height), 0);
}

export const standAgain = (kept: KeptStand): Stand => Object.assign(new Stand(), kept);
