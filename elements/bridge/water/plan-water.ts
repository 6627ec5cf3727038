import type { World } from '../../../physics-core/inside.js';
import { standInOf } from '../document/shortcuts.js';
import { collectionOf, placesOf } from '../document/structure.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { collectionNode, type Plan } from '../plans/plan.js';
import { boxIn, shapesOf } from './own-shapes.js';
import { placedIn } from './placed.js';
import { showSurface } from './surface/surfaces.js';
import { takeShapes } from './taken.js';

/** That of the collection that it stands in; else the only one, where bodies are that may float in it. */
export function worldOfWater(water: Binding): PageWorld | undefined {
  if (placesOf(water).length === 0) return undefined;
  const { worlds } = water.scene!;
  const collection = collectionOf(water);
  return collection ? worlds.of(collection) : (worlds.onlyFor(water) ?? worlds.default);
}

export function planWater(water: Binding, world: World): Plan | undefined {
  const standIn = standInOf(water);
  // Without what it stands for, nobody knows where it is.
  if (water.waiting.has('for')) return undefined;
  const shapes = standIn ? shapesOf(water, standIn) : [];
  const take = (): void => {
    takeShapes(water, water.node ? shapes : []);
    void showSurface(water, shapes);
  };
  water.onnode = take;
  return {
    world,
    collection: collectionNode(water),
    relations: standIn ? placedIn(water, standIn, boxIn(water, shapes, standIn)) : {},
  };
}
