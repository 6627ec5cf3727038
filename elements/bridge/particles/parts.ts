import type { Binding } from '../nodes/binding.js';

export const APPEARANCE = /^appearance$/;
export const COLOR = /^color(rgba)?$/;
export const TEX_COORD = /^texturecoordinate$/;
/** What is none of the other children that a system may have. */
export const GEOMETRY =
  /^(?!metadata|appearance$|color|texturecoordinate|.*(emitter|model|rigid-?body)$)/;

/** What a system is drawn with, beside its Appearance, of which x3dom tells by itself. */
export const LOOKS: readonly [field: string, tag: RegExp][] = [
  ['geometry', GEOMETRY],
  ['color', COLOR],
  ['texCoord', TEX_COORD],
];

/** The element of a system's field: one that is named, else a child of such a tag. */
export const partOf = (system: Binding, name: string, tag: RegExp): Element | undefined =>
  system.named(name)?.[0] ??
  [...system.element.children].find((each) => tag.test(each.localName.toLowerCase()));
