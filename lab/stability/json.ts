/** JSON has no words for them: they would come back as null. */
const NO_NUMBERS = [NaN, Infinity, -Infinity];

/** Numbers of all kinds, to be read by `fromText`. */
export const toText = (value: unknown, indent?: number): string =>
  JSON.stringify(
    value,
    (_, one: unknown) => (typeof one === 'number' && NO_NUMBERS.includes(one) ? String(one) : one),
    indent,
  );

const back = new Map(NO_NUMBERS.map((one) => [String(one), one]));

export const fromText = (text: string): unknown =>
  JSON.parse(text, (_, one: unknown) => (typeof one === 'string' ? (back.get(one) ?? one) : one));
