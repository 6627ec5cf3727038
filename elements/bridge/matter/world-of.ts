import { collectionOf, placesOf } from '../document/structure.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';

/** That of the collection that it stands in; else the only one, where bodies are that it may meet. */
export function worldAround(binding: Binding): PageWorld | undefined {
  if (placesOf(binding).length === 0) return undefined;
  const { worlds } = binding.scene!;
  const collection = collectionOf(binding);
  return collection ? worlds.of(collection) : (worlds.onlyFor(binding) ?? worlds.default);
}
