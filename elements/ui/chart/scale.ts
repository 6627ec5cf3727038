/** A logarithmic axis: powers of ten at its ends, and the pixels at which they are drawn. */
export interface Scale {
  min: number;
  max: number;
  from: number;
  to: number;
}

/** The powers of ten around some values, one decade apart at least. */
export function decades(values: readonly number[]): Pick<Scale, 'min' | 'max'> {
  const min = 10 ** Math.floor(Math.log10(Math.min(...values)));
  const max = 10 ** Math.ceil(Math.log10(Math.max(...values)));
  return { min, max: max > min ? max : min * 10 };
}

/** Pixels. */
export const at = ({ min, max, from, to }: Scale, value: number): number =>
  from + ((to - from) * Math.log10(value / min)) / Math.log10(max / min);

/** Its powers of ten; where they would stand closer than `room` pixels, every second, third … of them. */
export function ticks({ min, max, from, to }: Scale, room: number): number[] {
  const [first, last] = [min, max].map((value) => Math.round(Math.log10(value))) as [
    number,
    number,
  ];
  const apart = Math.abs(to - from) / (last - first);
  const every = Math.ceil(room / apart);
  const count = Math.floor((last - first) / every) + 1;
  return Array.from({ length: count }, (_, i) => 10 ** (first + i * every));
}
