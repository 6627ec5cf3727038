import type { DrawingNumbers, RoomRow, Row } from './numbers.js';

const ms = (value: number): string => value.toFixed(value < 10 ? 1 : 0);
const times = (value: number): string => value.toFixed(value < 10 ? 1 : 0);

const table = (heads: string[], rows: (string | number)[][]): string =>
  [heads, heads.map(() => '---:'), ...rows].map((cells) => `| ${cells.join(' | ')} |`).join('\n');

const SCRIPT = [
  'bodies',
  'one by one, ms',
  'in one call, ms',
  'times',
  'three.js, ms',
  'calls of WebGL',
  'in one call',
  'three.js',
];

const line = ({ bodies, plain, batched, three }: Row): (string | number)[] => [
  bodies,
  ...[plain.ms, batched.ms].map(ms),
  (plain.ms / batched.ms).toFixed(1),
  three.ms.toFixed(1),
  ...[plain, batched, three].map(({ calls }) => calls),
];

function scriptText({ rows, measured }: DrawingNumbers): string {
  const of = (kind: Row['webgl']): string =>
    table(SCRIPT, rows.filter(({ webgl }) => webgl === kind).map(line));
  return `WebGL doing nothing:

${of('none')}

The same with WebGL in software, where script waits for it:

${of('software')}

Measured ${measured.rows}; canvases of 64 × 48 pixels.`;
}

function editsText({ edits, measured }: DrawingNumbers): string {
  const kinds = Object.keys(edits[0]?.ms ?? {});
  const rows = edits.map((row) => [row.bodies, ...kinds.map((kind) => row.ms[kind]!.toFixed(2))]);
  const [few, many] = [edits[0], edits.at(-1)];
  const ratio = kinds.map((kind) => times(many!.ms[kind]! / few!.ms[kind]!));
  return `${table(['bodies', ...kinds], [...rows, ['times', ...ratio]])}

Measured ${measured.edits}.`;
}

const roomLine = ({ boxes, plain, batched }: RoomRow): (string | number)[] => [
  boxes,
  ms(batched.physics),
  ...[plain, batched].map(({ drawing }) => ms(drawing)),
  ...[plain, batched].map(({ frame }) => ms(frame)),
  ...[plain, batched].map(({ frame }) => (1000 / frame).toFixed(1)),
];

const ROOM = [
  'boxes',
  'physics, ms',
  'drawing one by one, ms',
  'in few calls, ms',
  'a frame one by one, ms',
  'in few calls, ms',
  'frames per second one by one',
  'in few calls',
];

const roomText = ({ room, measured }: DrawingNumbers): string =>
  `${table(ROOM, room.map(roomLine))}

Measured ${measured.room}; a canvas of 240 × 180 pixels, drawn in software.`;

/** Of docs/drawing.md, what is measured: by the name of its place there. */
export const tablesOf = (numbers: DrawingNumbers): Record<string, string> => ({
  script: scriptText(numbers),
  edits: editsText(numbers),
  room: roomText(numbers),
});
