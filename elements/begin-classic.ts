import { isMeasuring, takeOrders } from '../physics-core/accuracy/worker.js';
import { isRunningWorld, takeWorldOrders } from '../physics-core/thread/worker.js';
import { chunks, configure, type EngineSource } from '../physics-core/inside.js';
import { begin } from './begin.js';
import { scriptAddress } from './script-address.js';
import { setViewFolder } from './ui/view.js';

function beginInPage(engine: (address: string) => EngineSource): void {
  const address = scriptAddress();
  configure({ ...engine(address), workerUrl: address });
  setViewFolder(address);
  // All of them are in this file.
  for (const chunk of chunks) void chunk.load();
  begin();
}

/** What a classic script does: in a page it begins; as a worker that it starts itself, it measures, or runs a world. */
export function beginClassic(engine: (address: string) => EngineSource): void {
  if (isMeasuring()) takeOrders();
  else if (isRunningWorld()) takeWorldOrders();
  else beginInPage(engine);
}
