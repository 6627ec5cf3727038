// What the menu opens: site/gather/examples.ts takes it from the stories and the guide.

export interface Example {
  group: string;
  name: string;
  markup: string;
}

/** The library's words and the scenes, as the site serves them. */
export async function fetchJson<T>(address: string): Promise<T> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} did not load (${answer.status}).`);
  return answer.json() as Promise<T>;
}

/** An option for each, by groups; its value is its place in the list. */
export function fillMenu(menu: HTMLSelectElement, examples: readonly Example[]): void {
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const [i, { group, name }] of examples.entries()) {
    const options = groups.get(group) ?? document.createElement('optgroup');
    options.label = group;
    options.append(new Option(name, String(i)));
    groups.set(group, options);
  }
  menu.append(...groups.values());
}
