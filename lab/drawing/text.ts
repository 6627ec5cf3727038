/** One way of drawing: milliseconds of script per frame, calls of WebGL per frame. */
export interface Way {
  ms: number;
  calls: number;
}

export interface Row {
  bodies: number;
  /** Nothing behind it, so that script alone is measured, or drawn without a graphics card. */
  webgl: 'none' | 'software';
  plain: Way;
  batched: Way;
}

export interface DrawingNumbers {
  machine: string;
  day: string;
  rows: Row[];
  /** Milliseconds of one change among so many bodies. */
  edits: { bodies: number; ms: Record<string, number> }[];
}

const ms = (value: number): string => value.toFixed(value < 10 ? 1 : 0);

const line = ({ bodies, plain, batched }: Row): string =>
  `| ${bodies} | ${ms(plain.ms)} | ${ms(batched.ms)} | ${(plain.ms / batched.ms).toFixed(1)} | ${plain.calls} | ${batched.calls} |`;

const HEAD = `| bodies | one by one, ms | in one call, ms | times | calls of WebGL | in one call |
| ---: | ---: | ---: | ---: | ---: | ---: |`;

/** Of docs/drawing.md, what is measured. */
export function tableOf({ machine, day, rows, edits }: DrawingNumbers): string {
  const of = (kind: Row['webgl']): string =>
    [HEAD, ...rows.filter(({ webgl }) => webgl === kind).map(line)].join('\n');
  const kinds = Object.keys(edits[0]?.ms ?? {});
  const changes = edits.map(
    (row) => `| ${row.bodies} | ${kinds.map((kind) => row.ms[kind]!.toFixed(2)).join(' | ')} |`,
  );
  return `Script per frame, WebGL doing nothing:

${of('none')}

The same with WebGL in software, where script waits for it:

${of('software')}

One body changed, beyond a frame without a change, ms:

| bodies | ${kinds.join(' | ')} |
| ---: | ${kinds.map(() => '---:').join(' | ')} |
${changes.join('\n')}

Measured ${day}: ${machine}, Chromium, a canvas of 64 × 48 pixels.`;
}
