import type { Call, TimelineMark } from '../world/recording.js';
import type { World } from '../world/world.js';
import type { Pictures } from './pictures.js';

/** What follows of itself from what was done, or is one of many. */
const NOT_SHOWN = ['flush', 'move'];

/** What was done to a world, for people. */
export const marksOf = (world: World, calls: readonly Call[], pictures: Pictures): TimelineMark[] =>
  calls
    .filter(({ method }) => !NOT_SHOWN.includes(method))
    .map((call) => ({ time: timeOf(call, pictures), text: textOf(call, world) }));

/** Of the first picture that shows it. */
function timeOf({ step }: Call, pictures: Pictures): number {
  return pictures.at(Math.min(pictures.firstFrom('step', step), pictures.length - 1)).time;
}

function textOf({ node, method, args }: Call, world: World): string {
  const who = node === undefined ? undefined : world.node(node);
  const what = typeof args[0] === 'string' ? `${method} ${args[0]}` : method;
  return who ? `${who.label}: ${what}` : what;
}
