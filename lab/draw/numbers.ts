/** Numbers as people read them: two digits and a size word they know. */
const round = (value: number, digits = 2): string => String(Number(value.toPrecision(digits)));

const METRES: [number, string][] = [
  [1, 'm'],
  [1e-2, 'cm'],
  [1e-3, 'mm'],
  [1e-6, 'µm'],
  [1e-9, 'nm'],
];

/** 0.0123 m as "1.2 cm"; other units keep theirs. */
export function quantity(value: number | null, unit: string): string {
  if (value === null || !Number.isFinite(value)) return '–';
  if (value === 0) return `0 ${unit}`;
  if (unit !== 'm') return `${power(value)} ${unit}`;
  const [size, word] = METRES.find(([least]) => Math.abs(value) >= least * 0.995) ?? METRES.at(-1)!;
  return `${round(value / size)} ${word}`;
}

/** Without a size word: plain between a thousandth and ten thousand, else as a power of ten. */
export function power(value: number): string {
  const size = Math.abs(value);
  if (size === 0 || (size >= 0.001 && size < 1e4)) return round(value);
  const exponent = Math.floor(Math.log10(size));
  const digits = round(value / 10 ** exponent);
  return `${digits === '1' ? '' : `${digits}·`}10${superscript(exponent)}`;
}

const superscript = (n: number): string =>
  String(n).replaceAll(/[-\d]/g, (sign) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(sign)]!);

export const threeDigits = (value: number): string => round(value, 3);

export const percent = (share: number): string => `${round(share * 100)} %`;

export const milliseconds = (ms: number): string => `${round(ms)} ms`;

/** A step as a share of a second, which is how people know it. */
export const stepOf = (seconds: number): string => `1/${Math.round(1 / seconds)} s`;

/** How many times as large. */
export const times = (factor: number): string =>
  factor >= 9.95 ? `${Math.round(Number(factor.toPrecision(2)))} ×` : `${round(factor)} ×`;
