// What one can do to the scene of the first page: hold it, start it again, edit an attribute of it.
import { html } from 'lit';

type Collection = HTMLElementTagNameMap['x3d-rigid-body-collection'];

const mainOf = ({ currentTarget }: Event) => (currentTarget as Element).closest('main')!;
const collectionIn = (main: Element) =>
  main.querySelector<Collection>('x3d-rigid-body-collection')!;

function pause(event: Event): void {
  const { world } = collectionIn(mainOf(event));
  if (!world) return;
  world.paused = !world.paused;
  (event.currentTarget as Element).setAttribute('aria-pressed', String(world.paused));
}

function startAgain(event: Event): void {
  collectionIn(mainOf(event)).world?.reset();
}

/** The slider writes the attribute, as an author would by devtools; the line shows what stands there. */
function edit(event: Event): void {
  const main = mainOf(event);
  const { value } = event.currentTarget as HTMLInputElement;
  const gravity = `0 ${-Number(value)} 0`;
  collectionIn(main).setAttribute('gravity', gravity);
  main.querySelector('.edited')!.textContent = gravity;
}

export const controls = html`
  <div class="buttons">
    <button type="button" aria-pressed="false" @click=${pause}>Pause</button>
    <button type="button" @click=${startAgain}>Start again</button>
    <label class="gravity">
      Gravity
      <input type="range" min="0" max="20" step="0.2" value="9.8" @input=${edit} />
    </label>
  </div>
  <p class="line">
    <code
      >&lt;x3d-rigid-body-collection default draggable-body gravity="<b class="edited">0 -9.8 0</b
      >"&gt;</code
    >
  </p>
`;
