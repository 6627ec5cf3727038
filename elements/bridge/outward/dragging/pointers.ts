import type { Vec3 } from '../../../../physics-core/inside.js';
import type { Stage } from '../stage.js';
import type { By } from '../body.js';
import { Held } from './held.js';
import { metresOf, pick, scaled, type Picked } from './picking.js';
import { minus, plus, size, type View } from './view.js';

/** Mouse events by which x3dom turns the camera; it hears when a button goes down and up, so that clicks still count. */
const TURNING = ['mousemove', 'mouseout', 'mouseover', 'wheel', 'mousewheel', 'DOMMouseScroll'];
const TOUCHING = ['touchstart', 'touchmove', 'touchend', 'touchcancel'];

/** The nearest that Shift brings a body, as a share of its distance. */
const NEAREST = 0.9;

/** One pointer that holds a body. */
interface Grip {
  held: Held;
  /** In the lengths of the scene: what the plane passes through in which the pointer moves it. */
  anchor: Vec3;
  /** CSS pixels. */
  x: number;
  y: number;
}

/**
 * Mouse, touch and pen. The grabbed point follows the pointer in the plane through it that faces the viewer; with Shift,
 * moving up and down moves that plane away and nearer. x3dom's navigation rests meanwhile, and is left alone otherwise.
 */
export class Pointers {
  readonly #stage: Stage;
  readonly #view: View;
  readonly #grips = new Map<number, Grip>();
  readonly #listening = new AbortController();
  /** While something is held. */
  #holding: AbortController | undefined;
  /** Since something was grabbed, until nothing is down any more: x3dom did not hear how all of it began. */
  #pressing = false;
  #hover = 0;
  #shown: string | undefined;

  constructor(stage: Stage, view: View) {
    this.#stage = stage;
    this.#view = view;
    const options = { capture: true, signal: this.#listening.signal };
    // x3dom has put its own in the place of the element's method.
    const { addEventListener } = EventTarget.prototype;
    const listen = (type: string, listener: (event: never) => void, passive?: boolean): void =>
      addEventListener.call(stage.x3d, type, listener as EventListener, { ...options, passive });
    listen('pointerdown', this.#down);
    listen('pointermove', this.#move);
    listen('pointerup', this.#up);
    listen('pointercancel', this.#cancel);
    listen('lostpointercapture', this.#cancel);
    listen('dblclick', this.#doubleClick);
    for (const type of TURNING) listen(type, this.#rest, false);
    for (const type of TOUCHING) listen(type, this.#rest, false);
    // Bubbling: x3dom's own listener on the canvas comes first.
    addEventListener.call(stage.x3d, 'mousedown', this.#pressed, {
      signal: this.#listening.signal,
    });
  }

  destroy(): void {
    for (const { held } of [...this.#grips.values()]) held.cancel();
    this.#listening.abort();
    cancelAnimationFrame(this.#hover);
    this.#show(undefined);
  }

  // ---- a drag -----------------------------------------------------------------------------------------------------

  readonly #down = (event: PointerEvent): void => {
    if (event.button !== 0 || event.ctrlKey || event.altKey || event.metaKey) return;
    const picked = this.#under(event);
    if (picked) this.#grab(event, picked);
  };

  /** Only what is on the canvas: pages may lay their own buttons over it. */
  #under({ target, clientX, clientY }: MouseEvent): Picked | undefined {
    if (target !== this.#view.canvas) return undefined;
    const sight = this.#view.sight(clientX, clientY);
    return sight && pick(this.#stage, sight);
  }

  #grab({ pointerId, pointerType, clientX: x, clientY: y }: PointerEvent, picked: Picked): void {
    const by: By = pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse';
    const held = Held.take(this.#stage, picked, by, () => this.#ended(pointerId));
    if (!held) return;
    const anchor = scaled(picked.point, 1 / metresOf(picked.binding));
    this.#grips.set(pointerId, { held, anchor, x, y });
    this.#pressing = true;
    this.#show('grabbing');
    if (!this.#holding) this.#watch();
    capture(this.#view.canvas!, pointerId);
  }

  /** Escape is pressed wherever the focus is; a page that is hidden hears of no pointer going up. */
  #watch(): void {
    this.#holding = new AbortController();
    const options = { capture: true, signal: this.#holding.signal };
    window.addEventListener('keydown', this.#key, options);
    document.addEventListener('visibilitychange', this.#cancelAll, options);
  }

  readonly #move = (event: PointerEvent): void => {
    const grip = this.#grips.get(event.pointerId);
    // It went up where nobody saw it.
    if (grip && event.buttons === 0) grip.held.end();
    else if (grip) this.#moveGrip(grip, event);
    else if (event.pointerType === 'mouse' && event.buttons === 0) this.#lookLater(event);
  };

  #moveGrip(grip: Grip, { clientX, clientY, shiftKey }: PointerEvent): void {
    if (shiftKey) this.#moveAway(grip, grip.y - clientY);
    [grip.x, grip.y] = [clientX, clientY];
    const sight = this.#view.sight(clientX, clientY);
    const point = sight && this.#view.meet(sight, grip.anchor);
    if (point) grip.held.move(scaled(point, metresOf(grip.held.binding)));
  }

  /** Moves the plane by as much as so many pixels measure in it. */
  #moveAway(grip: Grip, pixels: number): void {
    const ahead = this.#view.ahead();
    const pixel = this.#view.pixel(grip.anchor);
    const sight = this.#view.sight(grip.x, grip.y);
    if (!ahead || !pixel || !sight) return;
    const room = NEAREST * size(minus(grip.anchor, sight.from));
    grip.anchor = plus(grip.anchor, ahead, Math.max(-room, pixels * size(pixel.up)));
  }

  readonly #up = (event: PointerEvent): void => {
    this.#grips.get(event.pointerId)?.held.end();
  };

  readonly #cancel = (event: PointerEvent): void => {
    this.#grips.get(event.pointerId)?.held.cancel();
  };

  readonly #cancelAll = (): void => {
    for (const { held } of [...this.#grips.values()]) held.cancel();
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    this.#cancelAll();
  };

  #ended(pointerId: number): void {
    this.#grips.delete(pointerId);
    if (this.#grips.size > 0) return;
    this.#holding?.abort();
    this.#holding = undefined;
    this.#show(undefined);
  }

  // ---- x3dom ------------------------------------------------------------------------------------------------------

  /** It heard the press, so that clicks count; but no navigation is to begin with it. */
  readonly #pressed = (): void => {
    if (this.#grips.size > 0) this.#view.forgetPress();
  };

  /** Neither x3dom nor the page's scrolling hears of what moves a body. */
  readonly #rest = (event: Event): void => {
    if (this.#grips.size === 0) {
      this.#pressing &&= isDown(event as MouseEvent | TouchEvent);
      if (!this.#pressing) return;
    }
    event.stopImmediatePropagation();
    if (event.cancelable && event.type !== 'mousemove') event.preventDefault();
  };

  /** Would turn the camera to it. */
  readonly #doubleClick = (event: MouseEvent): void => {
    if (this.#under(event)) event.stopImmediatePropagation();
  };

  // ---- the cursor -------------------------------------------------------------------------------------------------

  #lookLater(event: PointerEvent): void {
    cancelAnimationFrame(this.#hover);
    this.#hover = requestAnimationFrame(() => {
      if (this.#grips.size === 0) this.#show(this.#under(event) ? 'move' : undefined);
    });
  }

  /** x3dom's own cursor is a hand that would grab the scene. */
  #show(cursor: 'move' | 'grabbing' | undefined): void {
    const { canvas } = this.#view;
    if (!canvas || cursor === this.#shown) return;
    this.#shown = cursor;
    if (cursor) canvas.style.setProperty('cursor', cursor, 'important');
    else canvas.style.removeProperty('cursor');
  }
}

/** Whether a button or a finger is down still. */
const isDown = (event: MouseEvent | TouchEvent): boolean =>
  'touches' in event ? event.touches.length > 0 : event.buttons > 0;

/** Its moves go on outside the canvas; a pointer that is up already can't be captured. */
function capture(canvas: HTMLCanvasElement, pointerId: number): void {
  try {
    canvas.setPointerCapture(pointerId);
  } catch {
    return;
  }
}
