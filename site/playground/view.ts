// What one sees: buttons, the text, the scene, a line that says what happened.

const PAGE = `
<h1>Playground</h1>
<div class="bar" role="toolbar" aria-label="The scene">
  <select data-part="menu" aria-label="Open an example"><option value="">Examples</option></select>
  <button type="button" data-part="pause" aria-pressed="false">Pause</button>
  <button type="button" data-part="step" title="One step of the simulation; pauses first">Step</button>
  <button type="button" data-part="reset" title="Begin anew from the text">Reset</button>
  <button type="button" data-part="share" title="Copies an address that holds the whole text">Share</button>
  <button type="button" data-part="download" title="A page that runs from disk">Download</button>
  <output data-part="time" aria-live="off"></output>
</div>
<div class="panes">
  <div class="text" data-part="text"></div>
  <div class="scene" data-part="scene"></div>
</div>
<div class="foot">
  <p class="word" data-part="word" role="status"></p>
  <p class="keys" id="playground-keys">Tab indents. Escape, then Tab leaves the text.</p>
</div>`;

const PARTS = [
  'menu',
  'pause',
  'step',
  'reset',
  'share',
  'download',
  'time',
  'text',
  'scene',
  'word',
] as const;

type Part = Exclude<(typeof PARTS)[number], 'menu'>;

export type View = Record<Part, HTMLElement> & { menu: HTMLSelectElement };

export function createView(element: HTMLElement): View {
  element.classList.add('x3d-playground');
  element.setAttribute('role', 'main');
  element.innerHTML = PAGE;
  const part = (name: string) => element.querySelector(`[data-part=${name}]`);
  return Object.fromEntries(PARTS.map((name) => [name, part(name)])) as View;
}
