/// <reference types="vite/client" />
// The playground: markup on one side, its scene on the other. What one types is done to the running scene.
import { fetchJson, type Example } from './examples.js';
import { Playground } from './playground.js';
import './playground.css';
import { createView } from './view.js';
import type { Manifest } from './editor/vocabulary.js';

export { playgroundAddress } from './address.js';

/** What one sees who comes for the first time: first.html. */
const FIRST = 'a-pile-to-knock-over';

/** Where the site lies, as a whole address. */
const site = (): string => new URL(import.meta.env.BASE_URL, location.href).href;

/** Shows the playground in `element`; answers what takes it away again. `pictures`: those that the site has. */
export function mount(element: HTMLElement, pictures: readonly string[] = []): () => void {
  const ended = new AbortController();
  const view = createView(element);
  const tell = (text: string) => (view.word.textContent = text);
  start(element, view, pictures, ended.signal).catch((error: Error) => tell(error.message));
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
  pictures: readonly string[],
  ended: AbortSignal,
): Promise<void> {
  const [manifest, examples] = await Promise.all([
    fetchJson<Manifest>(`${site()}x3d-physics/custom-elements.json`),
    fetchJson<Example[]>(`${site()}scenes/examples.json`),
  ]);
  if (ended.aborted) return;
  for (const each of examples) if (!pictures.includes(each.picture!)) delete each.picture;
  const playground = new Playground(view, site(), manifest, examples);
  ended.addEventListener('abort', () => playground.end());
  await playground.openScene();
  if (ended.aborted) return;
  await playground.openAddress(examples.find(({ id }) => id === FIRST) ?? examples[0]);
  addEventListener('hashchange', () => void playground.openAddress(), { signal: ended });
  element.dataset.ready = '';
}
