// What one sees: buttons, the text and what is said of it, the scene, a line that says what happened.

const PAGE = `
<h1>Playground</h1>
<div class="bar" role="toolbar" aria-label="The scene">
  <select data-part="menu" aria-label="Open an example"><option value="">Your own</option></select>
  <button type="button" data-part="pause" aria-pressed="false">Pause</button>
  <button type="button" data-part="step" title="One step of the simulation; pauses first">Step</button>
  <button type="button" data-part="reset" title="Begin anew from the text">Reset</button>
  <button type="button" data-part="record" aria-pressed="false" title="Begins anew, and keeps what happens and what you do: the last 30 seconds">Record</button>
  <button type="button" data-part="play" title="Shows what was recorded" hidden>Play</button>
  <button type="button" data-part="panel" aria-pressed="false" title="Cost, accuracy, and which effects run because of what">Look inside</button>
  <button type="button" data-part="share" title="Copies an address that holds the text, and what was recorded">Share</button>
  <button type="button" data-part="download" title="One page, which runs by double click and without a network">Download</button>
  <button type="button" data-part="open" title="A scene and what was recorded of it, from a file; or drop the file here">Open run</button>
  <output data-part="time" aria-live="off"></output>
</div>
<div class="panes">
  <div class="left">
    <div class="text" data-part="text"></div>
    <ul class="told" data-part="told" aria-label="What is said of the text" aria-live="polite"></ul>
    <p class="scripts" data-part="scripts"></p>
  </div>
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
  'record',
  'play',
  'panel',
  'share',
  'download',
  'open',
  'time',
  'text',
  'told',
  'scripts',
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
