const internals = new WeakMap<Element, ElementInternals>();

/** What custom elements show by `:state(…)`. */
export function keepInternals(element: HTMLElement): void {
  internals.set(element, element.attachInternals());
}

export function setState(element: Element, state: string, on: boolean): void {
  // Older browsers have internals without states.
  const states = internals.get(element)?.states as Set<string> | undefined;
  if (on) states?.add(state);
  else states?.delete(state);
}
