// Processor seconds (user and system) of our own process and of all that it starts, by stage: what is bounded is work,
// which a slow or a busy machine does not stretch as it does the clock.
import { AsyncLocalStorage } from 'node:async_hooks';
import { readdirSync, readFileSync } from 'node:fs';

/** Linux alone says so of any process; elsewhere nothing is counted. */
export const isCounted = process.platform === 'linux';

/** Milliseconds between two looks: what ends in between is missing by that much at most. */
const APART = 200;

/** Ticks a second in which Linux counts, on every machine that Node runs on. */
const TICKS = 100;

/** What is counted for nobody else. */
const OURS = 'the rest';

const stages = new AsyncLocalStorage();
/** By process: its stage, and the seconds it had taken when it was seen last. */
const seen = new Map([[process.pid, { stage: OURS, seconds: 0 }]]);

/** Its parent, and what it has taken; undefined where it has ended. */
function read(pid) {
  try {
    const text = readFileSync(`/proc/${pid}/stat`, 'latin1');
    // Its name, in parentheses, may hold blanks.
    const fields = text.slice(text.lastIndexOf(')') + 2).split(' ');
    return {
      parent: Number(fields[1]),
      seconds: (Number(fields[11]) + Number(fields[12])) / TICKS,
    };
  } catch {
    return undefined;
  }
}

/** What a process starts belongs to its stage, and stays there when its parent ends. */
function look() {
  const running = readdirSync('/proc')
    .filter((name) => /^\d+$/.test(name))
    .map((name) => [Number(name), read(name)])
    .filter(([, found]) => found);
  const parents = new Map(running.map(([pid, { parent }]) => [pid, parent]));
  const stageOf = (pid) =>
    seen.get(pid)?.stage ?? (parents.has(pid) ? stageOf(parents.get(pid)) : undefined);
  for (const [pid, { seconds }] of running) {
    const stage = stageOf(pid);
    if (stage) seen.set(pid, { stage, seconds });
  }
}

/** Counts from now on. */
export function countProcessorTime() {
  if (isCounted) setInterval(look, APART).unref();
}

/** What `act` starts is counted for the stage of this name. */
export const inStage = (name, act) => stages.run(name, act);

/** A process that was started just now: the stage that it is started in has it. */
export function started(pid) {
  if (isCounted && pid) seen.set(pid, { stage: stages.getStore() ?? OURS, seconds: 0 });
}

/** Seconds so far, by stage, those of the rest last. */
export function processorSeconds() {
  if (isCounted) look();
  const total = new Map();
  for (const { stage, seconds } of seen.values())
    total.set(stage, (total.get(stage) ?? 0) + seconds);
  const ours = total.get(OURS);
  total.delete(OURS);
  return [...total, [OURS, ours]];
}
