import type { Engine } from '../../engine/engine.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import { momentIn } from './bodies.js';
import { statesIn } from './states.js';
import { loadNode, loadState } from './load.js';
import { Lookup } from './lookup.js';
import { goneIn, type RestoredWorld } from './restore.js';
import type { Snapshot } from './snapshot.js';

/**
 * Makes an empty world as the one a snapshot was taken of, in any engine: what it needs is all plain data. In pieces, so
 * that nobody need be held up: each `next` goes on by one node. `settings`: fields of its collection that are others here.
 * `elsewhere`: at another level.
 */
export function* copyInto(
  world: RestoredWorld,
  snapshot: Snapshot,
  engine: Engine,
  settings: Record<string, unknown> = {},
  elsewhere = Object.keys(settings).length > 0,
): Generator<void> {
  const born = new Map<number, PhysicsNode>();
  const states = statesIn(snapshot);
  for (const { id, type, name, version, collection, start } of states) {
    const group = collection === undefined ? undefined : born.get(collection);
    born.set(id, world.add(type, {}, { id, name, version, collection: group, start }));
    yield;
  }
  const found = new Lookup(world.nodes, snapshot, goneIn(world));
  const heard = new Map(snapshot.heard);
  for (const { id, collection } of states) {
    // It may have been born after those that belong to it.
    if (collection !== undefined) born.get(id)!.collection = born.get(collection);
    loadNode(born.get(id)!, found, elsewhere);
    adoptChildren(born.get(id)!, found);
    for (const event of heard.get(id) ?? []) born.get(id)!.on(event, () => {});
    yield;
  }
  for (const [name, value] of Object.entries(settings)) world.set(name, value);
  world.control.begin(snapshot.level, snapshot.parts);
  world.bodies.countFrom(snapshot.origin);
  yield* world.lifecycle.starting(engine);
  world.bodies.countFrom(undefined);
  world.stepping.resume(snapshot.time, snapshot.taken);
  loadState(world, snapshot, momentIn(snapshot));
}

/** What was made for a field goes with its node here, too, and is made again with it. */
function adoptChildren({ fieldState, children }: PhysicsNode, { states }: Lookup): void {
  for (const [name, value] of fieldState.asked) {
    const own = [value]
      .flat()
      .filter((item) => item instanceof PhysicsNode)
      .filter(({ id }) => states.get(id)?.child);
    if (own.length > 0) children.of.set(name, own);
  }
}
