/** Colours by what they stand for, in the light and in the dark; engines differ for eyes that see few colours too. */
const INKS = {
  ink: ['#1b1f24', '#e6e8eb'],
  soft: ['#57606a', '#a8b0b9'],
  line: ['#d8dee4', '#3a4149'],
  ground: ['#ffffff', '#16191d'],
  link: ['#0b5cad', '#7cc0ff'],
  ours: ['#0072b2', '#56b4e9'],
  ammo: ['#4d4d4e', '#c4c5c6'],
  'x-ite': ['#a8437f', '#e9a3cb'],
  cannon: ['#9a6a00', '#f0bd4f'],
  rapier: ['#007a59', '#3fcb9f'],
  jolt: ['#c04d00', '#ff9557'],
  iterated: ['#b85000', '#ffa066'],
} as const satisfies Record<string, readonly [string, string]>;

type Ink = keyof typeof INKS;

/** As charts are drawn with it. */
export const ink = (name: Ink): string => INKS[name][0];
export const inkOf = (engine: string): string => ink(engine as Ink);

const declared = (i: 0 | 1): string =>
  Object.entries(INKS)
    .map(([name, values]) => `--${name}: ${values[i]};`)
    .join(' ');

/** Custom properties for both themes. */
export const INK_STYLE = `:root { color-scheme: light dark; ${declared(0)} }
@media (prefers-color-scheme: dark) { :root { ${declared(1)} } }`;

/** A drawing whose colours follow the theme of the page around it. */
export const themed = (svg: string): string =>
  Object.entries(INKS).reduce(
    (text, [name, [light]]) => text.replaceAll(light, `var(--${name})`),
    svg,
  );

/** The same, with the themes inside: for a page that knows nothing of them. */
export const standalone = (svg: string): string =>
  themed(svg).replace(/(<svg[^>]*>)/, `$1<style>${INK_STYLE.replaceAll(':root', 'svg')}</style>`);
