/** Properties that a framework set before an element was defined hide its accessors: they are set again, through these. */
export function setAgain(element: object, names: Iterable<string>): void {
  const own = element as Record<string, unknown>;
  for (const name of names) {
    if (!Object.hasOwn(own, name)) continue;
    const value = own[name];
    delete own[name];
    own[name] = value;
  }
}
