import { frameCosts } from '../effects/costs/effects.js';
import { Stepping } from '../world/stepping/stepping.js';
import type { World } from '../world/world.js';
import type { Answer, Order, Stretch } from './messages.js';

/** What carries the passing of time to the other thread. */
interface Courier {
  refuse(method: string): null;
  /** Edits that wait are applied. */
  flush(): void;
  /** Time passed, or there is something to do. */
  send(): void;
  /** Something was done here of which the other side has not heard. */
  readonly due: boolean;
  readonly waits: boolean;
  /** Nothing was answered yet: the worker is being loaded, and that is no time of the world's. */
  readonly begins: boolean;
}

/** How a world passes time whose steps are taken on another thread. */
export class RemoteStepping extends Stepping {
  readonly #world: World;
  readonly #courier: Courier;
  #stretches: Stretch[] = [];
  #taken = 0;
  #needsFrame = true;
  /** Something is to be drawn since the last frame. */
  #fresh = true;
  #fraction = 1;
  /** What the other side last heard. */
  #paused = false;
  #timeScale = 1;

  constructor(world: World, courier: Courier) {
    super(world);
    this.#world = world;
    this.#courier = courier;
    this.follow(world.stepping);
  }

  /** Takes over what its author said. */
  follow({ paused, timeScale, time, taken }: Stepping): void {
    if (this.paused !== paused) this.paused = paused;
    if (this.timeScale !== timeScale) this.timeScale = timeScale;
    this.setTime(time);
    this.#taken = taken;
    this.singly = false;
  }

  override get taken(): number {
    return this.#taken;
  }

  override step(n: number): number {
    this.#world.flush();
    if (n > 0) this.#courier.refuse('step');
    return 0;
  }

  /** Time that passes while an answer is awaited goes with the next order. */
  override frame(seconds: number, seen: boolean): boolean {
    this.#courier.flush();
    this.singly = false;
    this.passed = seen ? seconds : 0;
    if (this.#goesOn) {
      this.#note(this.#courier.begins ? 0 : seconds, seen);
      this.#courier.send();
    }
    this.#draw();
    return this.needsFrame;
  }

  /** Where all is at rest, and nothing was done, there is nothing to say. */
  get #goesOn(): boolean {
    if (this.#courier.due || this.#courier.waits) return true;
    if (this.paused !== this.#paused || this.timeScale !== this.#timeScale) return true;
    return this.#needsFrame && (this.running || !!this.#world.timeline?.playing);
  }

  #note(seconds: number, seen: boolean): void {
    const last = this.#stretches.at(-1);
    if (last?.seen && seen) last.seconds += seconds;
    else this.#stretches.push({ seconds, seen });
  }

  #draw(): void {
    const { poses } = this.#world;
    if (this.#fresh) poses.interpolate(this.#fraction);
    else poses.movedCount = 0;
    this.#fresh = false;
  }

  /** What passed since it was asked last, and how time is to go on. */
  news(): Pick<Order, 'stretches' | 'paused' | 'timeScale'> {
    const { paused, timeScale } = this;
    const stretches = this.#stretches;
    this.#stretches = [];
    this.#paused = paused;
    this.#timeScale = timeScale;
    return { stretches, paused, timeScale };
  }

  take({ time, taken, fraction, needsFrame, stats, stopped }: Answer): void {
    this.setTime(time);
    if (taken > this.#taken) this.#world.registry.caused(frameCosts)?.afterStep();
    this.#taken = taken;
    this.#fraction = fraction;
    this.#needsFrame = needsFrame;
    this.#fresh = true;
    const { write } = this.ms;
    Object.assign(this.ms, stats.ms, { write });
    if (stopped) this.paused = true;
  }

  /** No answer will come any more. */
  stand(): void {
    this.#needsFrame = this.#fresh = false;
  }

  /** Something was done here that is to be drawn. */
  done(): void {
    this.#fresh = true;
  }

  override get running(): boolean {
    const { started, control, timeline } = this.#world;
    return started && !timeline?.looking && control.enabled && !this.paused && this.timeScale > 0;
  }

  override get needsFrame(): boolean {
    return this.#fresh || this.#goesOn;
  }
}
