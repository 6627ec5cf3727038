import type { Vec3 } from '../../../../physics-core/inside.js';
import { precedes } from '../../words/dom.js';
import type { Binding } from '../../nodes/binding.js';
import type { Stage } from '../stage.js';
import type { DraggableBody } from '../body.js';
import { HandleBox } from './handle-box.js';
import { Held } from './held.js';
import { bindingOf, metresOf, scaled } from './picking.js';
import { plus, size, type View } from './view.js';

/** Share of the picture's height by which a key moves a body. */
const STEP = 0.025;

/** Right, up and away, by key. With Shift, up and down move away and nearer. */
const MOVES: Record<string, Vec3> = {
  ArrowRight: [1, 0, 0],
  ArrowLeft: [-1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

/** To another body, by key: so many places on. */
const PLACES: Record<string, number> = {
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  Home: -Infinity,
  End: Infinity,
};

interface Handle {
  body: DraggableBody;
  binding: Binding;
  button: HTMLButtonElement;
}

/**
 * The keyboard's way: a button for each draggable body, shown around it while it has the focus. Tab reaches the bodies of a
 * scene, arrow keys go from one to the next, Enter or Space takes hold and lets go.
 */
export class Handles {
  readonly #stage: Stage;
  readonly #view: View;
  readonly #box: HandleBox;
  /** In document order. */
  readonly #handles: Handle[] = [];
  #held: Held | undefined;
  #frame = 0;
  /** The first one whose number may be another than its name says. */
  #renamed = Infinity;

  constructor(stage: Stage, view: View) {
    this.#stage = stage;
    this.#view = view;
    this.#box = new HandleBox(stage.x3d);
  }

  destroy(): void {
    this.#held?.cancel();
    cancelAnimationFrame(this.#frame);
    this.#box.remove();
  }

  // ---- which ------------------------------------------------------------------------------------------------------

  add(body: DraggableBody): void {
    const binding = bindingOf(body);
    if (!binding) return;
    const button = this.#box.button();
    const handle = { body, binding, button };
    button.addEventListener('click', () => this.#press(handle));
    button.addEventListener('keydown', (event) => this.#key(handle, event));
    button.addEventListener('focus', () => this.#focused(handle));
    button.addEventListener('blur', () => this.#blurred());
    const place = this.#handles.findLastIndex((each) => !isBefore(binding, each.binding)) + 1;
    this.#handles.splice(place, 0, handle);
    this.#box.insert(button, this.#handles[place + 1]?.button);
    this.#renameFrom(place);
  }

  remove(body: DraggableBody): void {
    const place = this.#handles.findIndex((each) => each.body === body);
    const [gone] = place < 0 ? [] : this.#handles.splice(place, 1);
    if (!gone) return;
    const focused = this.#box.focused === gone.button;
    gone.button.remove();
    this.#renameFrom(place);
    if (focused) this.#handles[Math.min(place, this.#handles.length - 1)]?.button.focus();
  }

  /** Once for all that come or go in one task: those without a name are numbered. */
  #renameFrom(place: number): void {
    if (this.#renamed === Infinity) queueMicrotask(() => this.#rename());
    this.#renamed = Math.min(this.#renamed, place);
  }

  #rename(): void {
    for (let i = this.#renamed; i < this.#handles.length; i++) this.#name(this.#handles[i]!, i);
    this.#renamed = Infinity;
    this.#offerToTab();
  }

  #name({ binding, button }: Handle, place: number): void {
    const name = nameOf(binding) ?? `${kindOf(binding)} ${place + 1}`;
    if (button.getAttribute('aria-label') !== name) button.setAttribute('aria-label', name);
  }

  /** The first one is the one that Tab reaches, until another one had the focus. */
  #offerToTab(): void {
    if (!this.#handles.some(({ button }) => button.tabIndex === 0))
      this.#handles[0]?.button.setAttribute('tabindex', '0');
  }

  #focused(handle: Handle): void {
    for (const { button } of this.#handles) button.tabIndex = button === handle.button ? 0 : -1;
    this.#name(handle, this.#handles.indexOf(handle));
    cancelAnimationFrame(this.#frame);
    this.#follow(handle);
  }

  #blurred(): void {
    cancelAnimationFrame(this.#frame);
    this.#held?.end();
  }

  /** The body moves, and so may the camera. */
  #follow(handle: Handle): void {
    const { body, binding, button } = handle;
    this.#frame = requestAnimationFrame(() => this.#follow(handle));
    const metres = metresOf(binding);
    const centre = scaled(body.centerOfMassWorld(), 1 / metres);
    const place = this.#view.place(centre);
    const pixel = this.#view.pixel(centre);
    const radius = pixel && body.size / metres / size(pixel.right);
    this.#box.show(button, place && { ...place, radius: radius ?? 0 });
  }

  // ---- keys -------------------------------------------------------------------------------------------------------

  #press({ body, binding, button }: Handle): void {
    if (this.#held) return this.#held.end();
    const name = button.getAttribute('aria-label')!;
    const picked = { body, binding, point: body.centerOfMassWorld() };
    this.#held = Held.take(this.#stage, picked, 'keyboard', (reason) => {
      this.#held = undefined;
      button.setAttribute('aria-pressed', 'false');
      this.#box.say(`${name} ${reason}`);
    });
    if (!this.#held) return;
    button.setAttribute('aria-pressed', 'true');
    this.#box.say(`${name} held`);
  }

  #key(handle: Handle, event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    // A key held down presses a button again and again.
    if (event.key === 'Enter' && event.repeat) return event.preventDefault();
    if (!(this.#held ? this.#move(event) : this.#choose(handle, event))) return;
    event.preventDefault();
    event.stopPropagation();
  }

  #choose(handle: Handle, { key }: KeyboardEvent): boolean {
    const places = PLACES[key];
    if (places === undefined) return false;
    const last = this.#handles.length - 1;
    const at = this.#handles.indexOf(handle) + places;
    this.#handles[Math.max(0, Math.min(last, at))]!.button.focus();
    return true;
  }

  #move({ key, shiftKey }: KeyboardEvent): boolean {
    if (key === 'Escape') this.#held!.cancel();
    const move = MOVES[key];
    if (!move) return key === 'Escape';
    const [right, up, away] = shiftKey ? [move[0], 0, move[1] + move[2]] : move;
    this.#moveBy(this.#held!, right, up, away);
    return true;
  }

  #moveBy(held: Held, right: number, up: number, away: number): void {
    const metres = metresOf(held.binding);
    const point = scaled(held.point, 1 / metres);
    const pixel = this.#view.pixel(point);
    const ahead = this.#view.ahead();
    if (!pixel || !ahead) return;
    const step = STEP * this.#view.canvas!.getBoundingClientRect().height;
    const across = plus(plus(point, pixel.right, right * step), pixel.up, up * step);
    held.move(scaled(plus(across, ahead, away * step * size(pixel.up)), metres));
  }
}

const isBefore = (a: Binding, b: Binding): boolean => precedes(standing(a), standing(b)) < 0;

/** In the page: bodies of one Inline stay in the order in which they came. */
const standing = ({ scope, element }: Binding): Element => scope?.pageHost ?? element;

/** As people say it: Body, Rope, Soft Body. */
const kindOf = ({ type }: Binding): string =>
  type.name === 'RigidBody' ? 'Body' : type.name.replace(/(?<=[a-z])[A-Z]/g, ' $&');

/** What people call a body, or the Transform that it moves. */
function nameOf({ element, name, standIn }: Binding): string | undefined {
  const by = (of: Element | undefined): string | undefined => {
    for (const attribute of ['aria-label', 'title', 'DEF', 'def', 'id']) {
      const text = of && Element.prototype.getAttribute.call(of, attribute)?.trim();
      if (text) return text;
    }
    return undefined;
  };
  return by(element) ?? name ?? by(standIn?.transform);
}
