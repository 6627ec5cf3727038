import { aFrame } from './a-frame.js';
import { ammo } from './ammo.js';
import type { Library } from './library.js';
import { ours, oursAwake, oursClassic, oursInWorker, oursXhtml } from './ours.js';
import { xIte } from './x-ite.js';

export const libraries: readonly Library[] = [
  ours,
  oursAwake,
  oursInWorker,
  oursClassic,
  oursXhtml,
  xIte,
  aFrame,
  ammo,
];

export function libraryOf(id: string): Library {
  const found = libraries.find((library) => library.id === id);
  if (!found) throw new Error(`no library ${id}`);
  return found;
}
