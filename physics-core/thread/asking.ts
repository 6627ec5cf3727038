import { show } from '../base/show.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import { bulletHas, touchedBy } from '../world/bullet-has.js';
import type { World } from '../world/world.js';

/** What can be asked of a world on whichever thread it runs. */
const ASKED = [
  'advance',
  'effects',
  'explain',
  'exportRun',
  'raycast',
  'snapshot',
  'stats',
  'step',
];

export async function ask(
  world: World,
  method: string,
  args: readonly unknown[],
): Promise<unknown> {
  if (!ASKED.includes(method)) return refuse(world, method);
  // Elements stay here.
  const said = method === 'explain' ? [world.node(args[0])] : args;
  return world.elsewhere ? world.elsewhere.ask(method, said) : answer(world, method, said);
}

/** What a world that runs here answers. */
export function answer(world: World, method: string, args: readonly unknown[]): unknown {
  if (method === 'explain') return knownOf(args[0] as PhysicsNode | undefined);
  const value = (world as unknown as Record<string, unknown>)[method];
  return typeof value === 'function' ? (value.apply(world, args) as unknown) : value;
}

/** What Bullet has of a node. */
const knownOf = (node: PhysicsNode | undefined): object => ({
  bullet: node && bulletHas(node),
  touches: node && touchedBy(node),
});

function refuse(world: World, method: unknown): void {
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'ask',
    value: method,
    used: 'nothing',
    message: `ask takes ${ASKED.join(', ')}, not ${show(method)}; nothing is asked`,
  });
}
