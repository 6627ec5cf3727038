// The scripts of the text, each by its line: they run in the scene's page, and begin anew when they change.
import type { ElementNode } from './text/tree.js';

export interface Script {
  line: number;
  source: ElementNode;
}

export function showScripts(
  place: HTMLElement,
  scripts: readonly Script[],
  goTo: (script: Script) => void,
): void {
  place.hidden = scripts.length === 0;
  const now = scripts.map(({ line, source }) => nameOf(line, source));
  if (place.dataset.shown !== now.join()) {
    place.dataset.shown = now.join();
    const one = scripts.length === 1;
    const head = one ? 'A script runs: ' : `${scripts.length} scripts run: `;
    const buttons = now.flatMap((name, i) => (i ? [', ', buttonOf(name)] : [buttonOf(name)]));
    place.replaceChildren(
      head,
      ...buttons,
      `. A change of ${one ? 'it' : 'them'} begins the scene anew.`,
    );
  }
  for (const [i, button] of place.querySelectorAll('button').entries())
    button.onclick = () => goTo(scripts[i]!);
}

function nameOf(line: number, { attributes }: ElementNode): string {
  const from = attributes.get('src')?.value;
  return from ? `${from}, line ${line}` : `line ${line}`;
}

function buttonOf(name: string): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = name;
  return button;
}
