import { SI, type Units } from '../../../physics-core/inside.js';
import { attribute } from './dom.js';

/** The `UNIT` statements of a file (ISO/IEC 19775-1, 7.2.5.5); the first of a category counts, as X3D says. */
export function unitsOf(file: Document | Element): Units {
  const units: Units = { ...SI };
  const seen = new Set<string>();
  for (const statement of file.querySelectorAll('unit, UNIT, Unit')) {
    const category = attribute(statement, 'category')?.trim().toLowerCase();
    const factor = Number(attribute(statement, 'conversionFactor'));
    if (!category || !(category in units) || seen.has(category) || !(factor > 0)) continue;
    seen.add(category);
    units[category as keyof Units] = factor;
  }
  return seen.size > 0 ? units : SI;
}
