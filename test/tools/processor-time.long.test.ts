import assert from 'node:assert/strict';
import { test } from 'node:test';
// @ts-expect-error plain JavaScript
import { runNode } from '../../tools/processes.js';
// @ts-expect-error plain JavaScript
import * as processor from '../../tools/processor-time.js';

const { countProcessorTime, inStage, isCounted, processorSeconds } = processor;

/** Seconds of the processor that a process and one that it starts are busy for, each. */
const BUSY = 0.4;

const busy = `const taken = () => Object.values(process.cpuUsage()).reduce((a, b) => a + b);
  while (taken() < ${BUSY * 1e6}) for (let i = 0; i < 1e6; i++);`;
const both = `require('node:child_process').spawn(process.execPath, ['-e', ${JSON.stringify(busy)}]); ${busy}`;

test(
  'what a stage starts, and what that starts, is counted for it alone',
  { skip: !isCounted },
  async () => {
    countProcessorTime();
    await Promise.all([
      inStage('one', () => runNode(['-e', both])),
      inStage('other', () => runNode(['-e', ''])),
    ]);
    const seconds = new Map<string, number>(processorSeconds());
    // It is looked at five times a second.
    const one = seconds.get('one')!;
    assert.ok(one > 2 * BUSY - 0.4 && one < 2 * BUSY + 0.6, `${one} s`);
    assert.ok(seconds.get('other')! < 0.4, `${seconds.get('other')} s`);
  },
);
