import { meantBy } from '../document/geometry-reader.js';
import { standInOf } from '../document/shortcuts.js';
import type { Binding } from '../nodes/binding.js';
import type { StandIn } from '../nodes/stand-in.js';
import type { Scope } from '../scopes/scope.js';
import { isShape, lowerName } from '../words/dom.js';

/** Along or over what something is laid, and the Shape that is seen of it. */
export interface Found<Data> {
  data?: Data | undefined;
  shape?: Element | undefined;
}

/** What an element is as a geometry; undefined where it is none. */
type Read<Data> = (element: Element, scope: Scope) => Data | undefined;

const NO_GEOMETRY = /^(appearance|metadata.*)$/;

/** In a rope or the like itself, and then beside it, or in what it is for, unless that `isOthers`. */
export function geometryOf<Data>(
  user: Binding,
  read: Read<Data>,
  isOthers: (standIn: StandIn) => boolean = () => false,
): Found<Data> {
  const own = user.named('geometry') ?? [...user.element.children];
  const within = pick(user, own, user.scope!, read);
  const standIn = standInOf(user);
  if (!standIn || (within.data && within.shape)) return within;
  const { shapes, scope } = standIn;
  user.scene!.readers.add(shapes, user);
  if (isOthers(standIn)) return within;
  const around = pick(user, isShape(shapes) ? [shapes] : [...shapes.children], scope, read);
  return { data: within.data ?? around.data, shape: within.shape ?? around.shape };
}

/** The first geometry; of Shapes the first that has one, else the first that has none at all: that is for this. */
function pick<Data>(
  user: Binding,
  elements: Element[],
  around: Scope,
  read: Read<Data>,
): Found<Data> {
  let empty: Element | undefined;
  for (const each of elements) {
    const { element, scope } = meantBy(user, each, around) ?? { element: each, scope: around };
    const data = read(element, scope);
    if (data) return { data };
    if (!isShape(element)) continue;
    user.scene!.readers.add(element, user);
    const parts = [...element.children].map(
      (part) => meantBy(user, part, scope) ?? { element: part, scope },
    );
    for (const part of parts) {
      const inside = read(part.element, part.scope);
      if (inside) return { data: inside, shape: element };
    }
    if (parts.every((part) => NO_GEOMETRY.test(lowerName(part.element)))) empty ??= element;
  }
  return { shape: empty };
}
