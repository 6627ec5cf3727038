import { loadedWorker } from '../world/worker.js';
import { NAME, type Answer, type Beginning, type Message, type Order } from './messages.js';

/** Whoever is spoken with: a worker, or an end of a channel. */
export interface Port {
  postMessage(message: unknown, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<Message>) => void) | null;
}

/** What is heard on a line. */
export interface Heard {
  answered(answer: Answer): void;
  /** Nobody is there, and never was. */
  missing(error: unknown): void;
  /** Whoever was there can't go on. */
  lost(error: unknown): void;
}

/** Workers that worlds of this page have now. */
let workers = 0;

export const workersNow = (): number => workers;

/** The way to the other thread: what is said before somebody is there waits. */
export class Line {
  #port: Port | undefined;
  #waiting: { message: Beginning | Order; room: Transferable[] }[] = [];
  #close: () => unknown = () => {};
  #closed = false;
  readonly #heard: Heard;

  constructor(heard: Heard) {
    this.#heard = heard;
  }

  /** Speaks with a worker of this library. */
  async call(workerUrl: string | URL | undefined): Promise<void> {
    workers++;
    this.#close = () => workers--;
    try {
      const worker = await loadedWorker(workerUrl, NAME);
      if (this.#closed) return worker.terminate();
      worker.onerror = (event) => {
        event.preventDefault();
        this.#lost(event.message);
      };
      this.speak(worker as Port, () => {
        workers--;
        worker.terminate();
      });
    } catch (error) {
      if (!this.#closed) this.#heard.missing(error);
    }
  }

  /** Somebody is there. */
  speak(port: Port, close: () => void): void {
    this.#port = port;
    this.#close = close;
    port.onmessage = ({ data }) => this.#hear(data);
    for (const { message, room } of this.#waiting.splice(0)) port.postMessage(message, room);
  }

  say(message: Beginning | Order, room: Transferable[] = []): void {
    if (this.#port) this.#port.postMessage(message, room);
    else this.#waiting.push({ message, room });
  }

  #hear(message: Message): void {
    if (this.#closed) return;
    if ('answer' in message) this.#heard.answered(message.answer);
    if ('failed' in message) this.#lost(message.failed);
  }

  #lost(error: unknown): void {
    if (this.#closed) return;
    this.close();
    this.#heard.lost(error);
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.#close();
  }
}
