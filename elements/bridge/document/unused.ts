import { namers, type Binding } from '../nodes/binding.js';
import { isPhysics } from '../words/dom.js';
import { parentIn } from '../scopes/instances.js';
import { placesOf } from './structure.js';

/**
 * Collidables that no body has and no list names: they live in no world. Told in a task of its own, for scripts and
 * frameworks may bring the body last.
 */
export class Unused {
  readonly #planned = new Set<Binding>();

  /** Who has it, if anybody, is known anew. */
  note(binding: Binding): void {
    if (!binding.isCollidable && !binding.is('CollisionSpace')) return;
    if (binding.world) return binding.settle(CODE);
    if (this.#planned.size === 0) setTimeout(() => this.#tell());
    this.#planned.add(binding);
  }

  #tell(): void {
    for (const binding of this.#planned) if (isUnused(binding)) report(binding);
    this.#planned.clear();
  }
}

const CODE = 'unused-collidable';

/** What stands in a physics node, or is named by one, is that one's matter, which is told of by itself. */
function isUnused(binding: Binding): boolean {
  if (!binding.scope || binding.world) return false;
  const places = placesOf(binding);
  return places.length > 0 && !places.some((place) => isHeld(place, binding));
}

function isHeld(place: Element, { scope }: Binding): boolean {
  const parent = parentIn(place, scope!.all.around(place) ?? scope!);
  return (!!parent && isPhysics(parent)) || namers.of(place, ...HOLDERS).length > 0;
}

const HOLDERS = ['CollidableOffset', 'CollisionSpace'];

function report(binding: Binding): void {
  binding.fault((faults) => faults.unused(binding, binding.isCollidable));
}
