import type { World as WorldObject } from '../world/world.js';
import type { World } from './world.js';

/** All of a world that has the same types inside. Where nodes come in they have others, which come from their tables. */
type Checked = Omit<
  World,
  'ready' | 'add' | 'node' | 'nodes' | 'get' | 'set' | 'on' | 'raycast' | 'ask'
>;

/** A world as people see it. */
export function shown(world: WorldObject): World {
  const checked: Checked = world;
  return checked as World;
}

/** What stands behind a world that somebody was shown. */
export function behind(world: World): WorldObject {
  const checked: Checked = world;
  return checked as WorldObject;
}
