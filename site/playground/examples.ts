// What the menu opens: site/gather/examples.ts takes it from the gallery, the guide, the recipes and the stories.

export interface Example {
  /** In addresses. */
  id: string;
  group: string;
  name: string;
  markup: string;
  /** Its address from where the site lies. */
  picture?: string;
}

/** The library's words and the scenes, as the site serves them. */
export async function fetchJson<T>(address: string): Promise<T> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} did not load (${answer.status}).`);
  return answer.json() as Promise<T>;
}

/** An option for each, by groups. The first stands for a text that is none of them. */
export function fillMenu(
  menu: HTMLSelectElement,
  examples: readonly Example[],
  site: string,
): void {
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const example of examples) {
    const { group } = example;
    const options = groups.get(group) ?? document.createElement('optgroup');
    options.label = group;
    options.append(optionOf(example, site));
    groups.set(group, options);
  }
  menu.append(...groups.values());
}

/** Browsers whose menus show no pictures show its name alone. */
function optionOf({ id, name, picture }: Example, site: string): HTMLOptionElement {
  const option = new Option('', id);
  const words = document.createElement('span');
  words.textContent = name;
  option.append(words);
  if (picture && CSS.supports('appearance', 'base-select')) option.prepend(imageAt(site + picture));
  return option;
}

function imageAt(address: string): HTMLImageElement {
  const image = document.createElement('img');
  image.alt = '';
  image.loading = 'lazy';
  image.src = address;
  return image;
}
