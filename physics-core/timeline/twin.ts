import { copyInto } from '../world/snapshot/copy.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { Call, HeldDrag } from '../world/recording.js';
import { World } from '../world/world.js';
import { Redoing } from './calls.js';

/** Where a run may begin. */
export interface Beginning {
  /** Steps since the recording began. */
  readonly step: number;
  readonly snapshot: Snapshot;
  readonly drags: readonly HeldDrag[];
}

/**
 * What was, anew, in a world beside the first: nobody hears of it, and the first does not move. Goes step by step from a
 * beginning to another step; what was done at that one itself is still to come.
 */
export function* twinOf(
  { engine }: World,
  { step: from, snapshot, drags }: Beginning,
  calls: readonly Call[],
  until: number,
  begun: (twin: World) => void = () => {},
): Generator<number, World> {
  const twin = new World({ console: false });
  for (const _ of copyInto(twin, snapshot, engine)) yield 0;
  const redoing = new Redoing(twin);
  for (const { drag, body, point } of drags) redoing.hold(drag, body, point);
  begun(twin);
  let next = calls.findIndex(({ step }) => step >= from);
  for (let step = from; step < until; step++) {
    for (; next >= 0 && calls[next]?.step === step; next++) redoing.do(calls[next]!);
    twin.step(1);
    yield (step + 1 - from) / (until - from);
  }
  return twin;
}
