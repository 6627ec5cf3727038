// Where a world runs that is shown by a page: a classic script, which is whole by itself, as a worker.
import { loadEngine } from '../engine/engine.js';
import { wholeCode } from '../world/whole-code.js';
import { recordings } from '../world/recording.js';
import { isWorkerNamed } from '../world/worker.js';
import { NAME, type Beginning, type Message, type Order } from './messages.js';
import { OtherSide } from './other-side.js';

/** The end of a line at which a world is run. */
export interface WorldPort {
  postMessage(message: Message, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<Beginning | Order>) => void) | null;
}

/** Runs a world for whoever speaks there: each order after the one before. Returns what ends it; a worker's goes with the worker. */
export function runWorld(port: WorldPort): () => void {
  let last: Promise<OtherSide | undefined> = Promise.resolve(undefined);
  port.onmessage = ({ data }) => {
    last = last.then((world) => ('snapshot' in data ? begin(data) : obey(port, world!, data)));
    last = last.catch((error) => {
      port.postMessage({ failed: String(error) }, []);
      return new Promise(() => {});
    });
  };
  return () => void last.then((world) => world?.destroy());
}

async function begin({ snapshot, program }: Beginning): Promise<OtherSide> {
  const code = [recordings, ...wholeCode].map((chunk) => chunk.load());
  const [engine] = await Promise.all([loadEngine({ program }), ...code]);
  return new OtherSide(snapshot, engine);
}

function obey(port: WorldPort, world: OtherSide, order: Order): OtherSide {
  const answer = world.take(order);
  port.postMessage({ answer }, [answer.states.buffer, answer.clouds.buffer]);
  return world;
}

/** Whether this is that worker. */
export const isRunningWorld = (): boolean => isWorkerNamed(NAME);

export function takeWorldOrders(): void {
  const port = globalThis as unknown as WorldPort;
  runWorld(port);
  port.postMessage({ ready: true }, []);
}
