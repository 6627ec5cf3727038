// The chunk `rope-elements`: ropes in pages, and what ties them.
import { ropeCode, softTypes } from '../physics-core/ropes.js';
import { drags } from '../physics-core/inside.js';
import { learnTypes } from './bridge/index.js';
import { placeRopes } from './bridge/ropes/place-ropes.js';
import { defineElements } from './define.js';
import { X3DRopeElement } from './x3d-rope.js';
import { X3DSoftBodyAttachmentElement } from './x3d-soft-body-attachment.js';

/** With what moves ropes. */
export async function whole(): Promise<{ provide(): void }> {
  // What they are taken by hand with; worlds tell where that can't be had.
  drags.load().catch(() => {});
  await ropeCode.load();
  return { provide };
}

function provide(): void {
  placeRopes();
  learnTypes(softTypes);
  defineElements([X3DRopeElement, X3DSoftBodyAttachmentElement]);
}
