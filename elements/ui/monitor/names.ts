/** An element as an author finds it: its DEF or id, and its tag. x3dom answers for attributes in its own way. */
export function nameOf(element: unknown): string {
  if (!(element instanceof Element)) return 'the page';
  const { getAttribute } = Element.prototype;
  const written = ['DEF', 'def', 'id'].map((name) => getAttribute.call(element, name));
  const name = written.find(Boolean);
  return name ? `${element.localName} "${name}"` : element.localName;
}
