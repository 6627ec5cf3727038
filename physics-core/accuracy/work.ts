/** Least milliseconds that are judged as one: clocks of browsers may tick no oftener. */
const BLOCK = 1;

/** What took so many times as long as usual, something else on the machine was at work in. */
const DISTURBED = 3;

/** Milliseconds of work per moment: the mean, with what was disturbed taken for what is usual. */
export function workPerMoment(times: readonly number[]): number {
  const blocks = blocksOf(times);
  const usual = median(blocks.map(({ ms, moments }) => ms / moments));
  const sum = blocks.reduce((all, { ms, moments }) => {
    const each = ms / moments;
    return all + moments * (each > DISTURBED * usual ? usual : each);
  }, 0);
  // A clock that ticks once a millisecond may have seen nothing of it: half a tick, then.
  return (sum || BLOCK / 2) / times.length;
}

interface Block {
  ms: number;
  moments: number;
}

function blocksOf(times: readonly number[]): Block[] {
  const blocks: Block[] = [{ ms: 0, moments: 0 }];
  for (const ms of times) {
    if (blocks.at(-1)!.ms >= BLOCK) blocks.push({ ms: 0, moments: 0 });
    const block = blocks.at(-1)!;
    block.ms += ms;
    block.moments++;
  }
  return blocks;
}

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}
