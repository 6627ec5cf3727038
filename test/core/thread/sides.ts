import type { World } from '../../../physics-core/inside.js';
import { Away } from '../../../physics-core/thread/away.js';
import { Line, type Port } from '../../../physics-core/thread/line.js';
import { runWorld, type WorldPort } from '../../../physics-core/thread/worker.js';

/** A world of this process goes on at the other end of a channel, as it does in a worker. */
export function goAway(world: World): Away {
  const { port1, port2 } = new MessageChannel();
  const end = runWorld(port2 as unknown as WorldPort);
  return new Away(world, (heard) => {
    const line = new Line(heard);
    line.speak(port1 as unknown as Port, () => {
      port1.close();
      end();
      port2.close();
    });
    return line;
  });
}

/** Until all that was said to the other side is answered. */
export async function answered(world: World): Promise<void> {
  await world.ask('stats');
}
