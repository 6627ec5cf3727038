/** How late an edit was seen: in which frame after it, and how far what is drawn was behind it by then. */
export interface Seen {
  frame: number;
  /** Milliseconds. */
  behind: number;
}

/** One edit under way: frames and milliseconds since, and from what height. */
interface Sent {
  frame: number;
  ms: number;
  from: number;
}

/** Metres per second, and frames that it stands still between. */
const SPEED = 10;
const REST = 12;

const MARKUP = `<Transform translation="40 40 0"><Shape><Sphere radius="0.3"></Sphere></Shape>
  <x3d-rigid-body useglobalgravity="false" autodisable="false"></x3d-rigid-body></Transform>`;

/** A ball that floats beside the scene, and is sent up right after a frame: what has the longest to wait. */
export class Probe {
  readonly seen: Seen[] = [];
  readonly #transform: any;
  readonly #body: Element;
  #rest = REST;
  #sent: Sent | undefined;

  constructor() {
    const scene = document.querySelector('scene')!;
    scene.insertAdjacentHTML('beforeend', MARKUP);
    this.#transform = scene.lastElementChild!;
    this.#body = this.#transform.querySelector('x3d-rigid-body');
  }

  /** What x3dom draws it at. */
  get #height(): number {
    return this.#transform._x3domNode?._trafo._13 as number;
  }

  /** After each frame, so many milliseconds after the last one. */
  look(gap: number): void {
    if (this.#sent) this.#wait(this.#sent, gap);
    else if (this.#rest-- <= 0) this.#send();
  }

  #send(): void {
    this.#sent = { frame: 0, ms: 0, from: this.#height };
    this.#go(SPEED);
  }

  #wait(sent: Sent, gap: number): void {
    sent.frame++;
    sent.ms += gap;
    const gone = this.#height - sent.from;
    if (gone === 0) return;
    this.seen.push({ frame: sent.frame, behind: sent.ms - (1000 * gone) / SPEED });
    this.#sent = undefined;
    this.#rest = REST;
    this.#go(0);
  }

  #go(speed: number): void {
    this.#body.setAttribute('linearvelocity', `0 ${speed} 0`);
  }
}
