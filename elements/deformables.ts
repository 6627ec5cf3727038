// The chunk `deformable-elements`: cloth and soft bodies in pages.
import { deformableCode, deformableTypes } from '../physics-core/deformables.js';
import { placeDeformables } from './bridge/deformables/place-deformables.js';
import { drags } from '../physics-core/inside.js';
import { learnTypes } from './bridge/index.js';
import { defineElements } from './define.js';
import { X3DClothElement } from './x3d-cloth.js';
import { X3DSoftBodyElement } from './x3d-soft-body.js';

/** With what moves them. */
export async function whole(): Promise<{ provide(): void }> {
  // What they are taken by hand with; worlds tell where that can't be had.
  drags.load().catch(() => {});
  await deformableCode.load();
  return { provide };
}

function provide(): void {
  placeDeformables();
  learnTypes(deformableTypes);
  defineElements([X3DClothElement, X3DSoftBodyElement]);
}
