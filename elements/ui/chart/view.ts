import styles from '../../../styles/chart.css';
import type { LevelMeasurement } from '../../../physics-core/inside.js';
import { render } from '../lit.js';
import { applyStyles } from '../styles.js';
import type { X3DUIElement } from '../ui-element.js';
import type { View } from '../view.js';
import type { ErrorName } from './errors.js';
import { panel, type Actions, type State } from './panel.js';
import { plot } from './plot.js';

/** Frames per second that the budget of a frame is reckoned with. */
const FRAMES = 60;

/** How often it looks for another world, milliseconds. */
const INTERVAL = 500;

/** Width over height of the drawing; its least width and bounds of its height, pixels. */
const SHAPE = 16 / 9;
const LEAST_WIDTH = 200;
const HEIGHTS = [240, 420] as const;

/** The element, which holds what was measured for whoever wants to keep it. */
interface Chart extends X3DUIElement {
  measured: readonly LevelMeasurement[] | undefined;
}

class ChartView implements View, Actions {
  readonly #host: Chart;
  readonly #root: ShadowRoot;
  readonly #size = new ResizeObserver(() => this.#draw());
  #state: State;
  #timer: ReturnType<typeof setInterval> | undefined;
  #stopHearing: (() => void) | undefined;
  #measuring: AbortController | undefined;

  constructor(host: Chart) {
    this.#host = host;
    this.#root = host.shadowRoot!;
    this.#state = {
      world: undefined,
      measured: host.measured,
      kept: true,
      kind: 'position',
      progress: undefined,
      failed: undefined,
    };
    applyStyles(host, styles);
  }

  start(): void {
    this.#timer = setInterval(() => this.#follow(), INTERVAL);
    this.#takeKept();
    this.#show();
    this.#hear();
    this.#follow();
    this.#size.observe(this.#host);
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#stopHearing?.();
    this.#size.disconnect();
    if (!this.#host.isConnected) this.cancel();
  }

  changed(): void {
    if (!this.#timer) return;
    this.#takeKept();
    this.#follow();
  }

  #takeKept(): void {
    const { measured } = this.#host;
    if (measured !== this.#state.measured) this.#show({ measured, kept: true, failed: undefined });
  }

  #hear(): void {
    this.#stopHearing?.();
    this.#stopHearing = this.#state.world?.on('accuracy', () => this.#show());
  }

  /** The page may have another world for it by now, or the one it has may have started. */
  #follow(): void {
    const { world } = this.#host;
    if (world !== this.#state.world) {
      this.cancel();
      // What was given before there is a world is meant for the first.
      const measured = this.#state.world ? undefined : this.#state.measured;
      this.#show({ world, measured, failed: undefined });
      this.#host.measured = measured;
      this.#hear();
    } else if (world?.started && !this.#root.querySelector('fieldset')) this.#show();
  }

  // ---- what its controls do -----------------------------------------------------------------------------------------

  readonly measure = async (): Promise<void> => {
    const { world } = this.#state;
    if (!world || this.#measuring) return;
    const measuring = (this.#measuring = new AbortController());
    this.#show({ progress: 0, failed: undefined });
    const ended: Partial<State> = {};
    try {
      const onprogress = (progress: number): void => this.#show({ progress });
      ended.measured = await world.measureAccuracy({ signal: measuring.signal, onprogress });
      ended.kept = false;
    } catch (error) {
      if (!measuring.signal.aborted) ended.failed = `Could not be measured: ${String(error)}`;
    }
    if (measuring !== this.#measuring) return;
    this.#measuring = undefined;
    this.#show({ ...ended, progress: undefined });
    if (ended.measured) this.#host.measured = ended.measured;
  };

  readonly cancel = (): void => {
    if (!this.#measuring) return;
    this.#measuring.abort();
    this.#measuring = undefined;
    this.#show({ progress: undefined });
  };

  readonly show = (kind: ErrorName): void => this.#show({ kind });

  // ---- drawing ------------------------------------------------------------------------------------------------------

  #show(change: Partial<State> = {}): void {
    this.#state = { ...this.#state, ...change };
    render(panel(this.#state, this), this.#root);
    if (this.#state.progress === undefined) this.#draw();
  }

  #draw(): void {
    const { measured, kind, world } = this.#state;
    const place = this.#root.querySelector<HTMLElement>('[part=chart]');
    if (!place || !measured || place.clientWidth === 0) return;
    const width = Math.max(LEAST_WIDTH, place.clientWidth);
    const drawing = {
      dots: measured.map(({ level, msPerSecond, error }) => ({
        level,
        cost: msPerSecond,
        error: error[kind],
        present: level === world?.accuracy,
      })),
      kind,
      budget: FRAMES * (world?.get('timeBudget') as number),
      width,
      height: Math.min(HEIGHTS[1], Math.max(HEIGHTS[0], Math.round(width / SHAPE))),
    };
    render(plot(drawing), place);
  }
}

export const createView = (host: X3DUIElement): View => new ChartView(host as Chart);
