/** Markup in both spellings, by the name of the spelling: plain tags from custom ones. */
export const bothSpellings = (markup: string): [spelling: string, markup: string][] => [
  ['custom', markup],
  ['plain', plain(markup)],
];

/** `x3d-rigid-body` as `RigidBody`. */
export const plain = (markup: string): string =>
  markup.replace(/(<\/?)x3d-([a-z-]+)/g, (_, open: string, name: string) => open + pascal(name));

const pascal = (name: string): string =>
  name
    .split('-')
    .map((word) => word[0]!.toUpperCase() + word.slice(1))
    .join('');
