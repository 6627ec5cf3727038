/// <reference types="vite/client" />
// The playground: markup on one side, its scene on the other. What one types is done to the running scene.
import { markupIn } from './address.js';
import { fetchJson, type Example } from './examples.js';
import { Playground } from './playground.js';
import './playground.css';
import { createView } from './view.js';
import type { Manifest } from './editor/vocabulary.js';

export { playgroundAddress } from './address.js';

/** Where the site lies, as a whole address. */
const site = (): string => new URL(import.meta.env.BASE_URL, location.href).href;

/** Shows the playground in `element`; answers what takes it away again. */
export function mount(element: HTMLElement): () => void {
  const ended = new AbortController();
  const view = createView(element);
  const tell = (text: string) => (view.word.textContent = text);
  start(element, view, ended.signal).catch((error: Error) => tell(error.message));
  return () => {
    ended.abort();
    element.classList.remove('x3d-playground');
    element.removeAttribute('role');
    delete element.dataset.ready;
    element.replaceChildren();
  };
}

async function start(
  element: HTMLElement,
  view: ReturnType<typeof createView>,
  ended: AbortSignal,
): Promise<void> {
  const [manifest, examples] = await Promise.all([
    fetchJson<Manifest>(`${site()}x3d-physics/custom-elements.json`),
    fetchJson<Example[]>(`${site()}scenes/examples.json`),
  ]);
  if (ended.aborted) return;
  const playground = new Playground(view, manifest, examples);
  ended.addEventListener('abort', () => playground.end());
  await playground.openScene(site());
  if (ended.aborted) return;
  await openAddress(playground, examples[0]!.markup);
  addEventListener('hashchange', () => void openAddress(playground), { signal: ended });
  element.dataset.ready = '';
}

/** What the address holds; where it holds nothing, `otherwise`. */
async function openAddress(playground: Playground, otherwise?: string): Promise<void> {
  try {
    const markup = (await markupIn(location.hash)) ?? otherwise;
    if (markup !== undefined) playground.open(markup);
  } catch (error) {
    if (otherwise !== undefined) playground.open(otherwise);
    playground.tell((error as Error).message);
  }
}
