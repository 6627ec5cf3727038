// The chunk `thread`.
import type { threads } from '../world/threading.js';
import type { World } from '../world/world.js';
import { Away } from './away.js';
import { Line } from './line.js';

export const provide = (): typeof threads.code => ({ leave });

function leave(world: World): void {
  new Away(world, (heard) => {
    const line = new Line(heard);
    void line.call(world.engine.source.workerUrl);
    return line;
  });
}
