import type { World } from '../../../physics-core/inside.js';
import { standInOf } from '../document/shortcuts.js';
import type { Binding } from '../nodes/binding.js';
import { collectionNode, type Plan } from '../plans/plan.js';
import { boxIn, shapesOf } from './own-shapes.js';
import { placedIn } from './placed.js';
import { showSurface } from './surface/surfaces.js';
import { takeShapes } from '../matter/taken.js';

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
