/** Red, green, blue, from 0 to 1. */
export type Color = readonly [number, number, number];

/** Everything that is drawn has one of these. Told apart on light and on dark grounds. */
const TABLE = {
  awake: { color: [0.1, 0.75, 0.25], means: 'awake body' },
  sleeping: { color: [0.35, 0.5, 0.95], means: 'body asleep' },
  fixed: { color: [0.55, 0.57, 0.6], means: 'fixed body' },
  kinematic: { color: [0.9, 0.55, 0.05], means: 'carried body' },
  out: { color: [0.75, 0.25, 0.25], means: 'body taken out: disabled, or without finite numbers' },
  mass: { color: [0, 0.7, 0.8], means: 'centre of mass' },
  joint: { color: [0.8, 0.25, 0.85], means: 'joint: what it holds, its axes, where it stands' },
  limit: { color: [1, 0.5, 0.8], means: 'stops of a joint' },
  contact: { color: [0.95, 0.75, 0], means: 'contact with its normal' },
  near: { color: [0.6, 0.5, 0.25], means: 'near, not touching' },
  ghost: { color: [0.55, 0.2, 1], means: 'ghost: the recorded run at another level' },
} as const satisfies Record<string, { color: Color; means: string }>;

type Name = keyof typeof TABLE;

export interface ColorMeaning {
  /** What has it, in a word. */
  readonly name: string;
  readonly color: Color;
  readonly means: string;
}

export const legend: readonly ColorMeaning[] = Object.entries(TABLE).map(([name, entry]) => ({
  name,
  ...entry,
}));

export const COLOR = Object.fromEntries(
  Object.entries(TABLE).map(([name, { color }]) => [name, color]),
) as unknown as { readonly [name in Name]: Color };
