import type { Chunk } from '../../base/chunk.js';
import { costs } from '../../effects/costs/effects.js';
import { outlines } from '../../effects/debug/debugging.js';
import { drags } from '../../effects/drag/effects.js';
import { contacts, joints } from '../../effects/effect/chunks.js';
import { advice } from '../../nodes/node/advice.js';
import { threads } from '../../nodes/node/threads.js';
import { meshes } from '../../shapes/meshes.js';

/** All code that nodes wait for; pages fetch it when it is needed. What comes late itself adds what its nodes wait for. */
export const chunks: Chunk<unknown>[] = [
  joints.comesFrom(() => import('./joint-code.js')),
  contacts.comesFrom(() => import('./contact-code.js')),
  drags.comesFrom(() => import('../../effects/drag-code.js')),
  costs.comesFrom(() => import('../../effects/cost-code.js')),
  meshes.comesFrom(() => import('../../shapes/mesh-code.js')),
  // The room that has it says where it is.
  threads,
];

// No node waits for these.
advice.comesFrom(() => import('../../nodes/node/advice-code.js'));
outlines.comesFrom(() => import('../../effects/debug-code.js'));
