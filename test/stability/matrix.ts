import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import type { StabilityCase } from '../../lab/stability/case.js';
import { themes } from '../../lab/stability/cases/index.js';
import { runCell } from '../../lab/stability/run.js';

const testedAt = ({ promisedFrom, alsoTested = [] }: StabilityCase) =>
  promisedFrom ? [promisedFrom, ...alsoTested] : [];

/** One test per cell: of each case, at the lowest level that promises it. */
export function promised(theme: string): void {
  describe(theme, () => {
    for (const which of themes[theme]!)
      for (const level of testedAt(which))
        test(`${which.id}: ${which.says} (${level})`, async () => {
          const { holds, measured, why } = await runCell(which, level);
          const { what, unit, most } = which.criterion;
          assert.ok(holds, why ?? `${what}: ${measured} ${unit} is more than ${most}`);
        });
  });
}
