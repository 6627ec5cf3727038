import { threeDigits } from '../draw/numbers.js';
import { columnsOf } from '../draw/table.js';
import type { BrowserPages, PageCell } from './numbers.js';

/** How far the run is, for people who wait for it. */
export function cellText(browser: string, { scene, count, script, frames }: PageCell): string {
  const rows = Object.entries(script).map(([side, cost]) => {
    if (typeof cost === 'string') return [side, cost, '', '', '', ''];
    const rate = frames[side];
    const perSecond = rate && typeof rate !== 'string' ? threeDigits(rate.perSecond) : '';
    const { script: all, physics, drawing, ours } = cost;
    const numbers = [all.median, physics.median, drawing.median].map(threeDigits);
    return [side, ...numbers, ours ? threeDigits(ours.median) : '', perSecond];
  });
  const head = ['', 'script, ms', 'physics', 'drawing', 'ours to it', 'frames/s'];
  return `${browser}, ${count} ${scene}\n${columnsOf([head, ...rows], 1)}`;
}

export const startText = (browser: string, { version, start }: BrowserPages): string =>
  `${browser} ${version}, ms to the first move: ${Object.entries(start)
    .map(([side, ms]) => `${side} ${typeof ms === 'string' ? ms : Math.round(ms.median)}`)
    .join(', ')}`;
