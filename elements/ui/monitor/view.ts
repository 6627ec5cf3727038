import styles from '../../../styles/monitor.css';
import { render } from '../lit.js';
import { applyStyles } from '../styles.js';
import type { X3DUIElement } from '../ui-element.js';
import type { View } from '../view.js';
import { panel } from './panel.js';

/** How often the numbers change, milliseconds: often enough to follow, seldom enough to read. */
const INTERVAL = 300;

type World = NonNullable<X3DUIElement['world']>;

class MonitorView implements View {
  readonly #host: X3DUIElement;
  #timer: ReturnType<typeof setInterval> | undefined;
  #world: World | undefined;
  #stopRecording: (() => void) | undefined;

  constructor(host: X3DUIElement) {
    this.#host = host;
    applyStyles(host, styles);
  }

  start(): void {
    this.#timer = setInterval(() => document.hidden || this.#show(), INTERVAL);
    this.#show();
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#follow(undefined);
  }

  changed(): void {
    if (this.#timer) this.#show();
  }

  /** The page may have another world for it by now, or none. */
  #follow(world: World | undefined): void {
    if (world === this.#world) return;
    this.#stopRecording?.();
    this.#world = world;
    this.#stopRecording = world?.recordCosts(this.#host, 'costs');
  }

  #show(): void {
    this.#follow(this.#host.world);
    render(panel(this.#world, this.#host.for, this.#refresh), this.#host.shadowRoot!);
  }

  readonly #refresh = (): void => this.#show();
}

export const createView = (host: X3DUIElement): View => new MonitorView(host);
