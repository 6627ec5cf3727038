import type { EmitterNode } from './emitter-node.js';
import { BoundedModelNode, WindModelNode, type ModelNode } from './model-node.js';
import type { PhysicsNode } from '../node/node.js';

// What looks as if it did something.

/** Tells of an emitter that bears nothing, and of models that move nothing. */
export function tellIdle(
  system: PhysicsNode,
  emitter: EmitterNode | undefined,
  models: readonly ModelNode[],
): void {
  system.reportWhile(emitter !== undefined && !emitter.bears, {
    code: 'idle-emitter',
    severity: 'warning',
    attribute: 'emitter',
    value: emitter?.type.name,
    used: 'no particles',
    message: `${system.label}: its ${emitter?.type.name} has nowhere to bear particles: a VolumeEmitter takes a closed surface, a SurfaceEmitter one with an area, a PolylineEmitter a line with a length`,
  });
  const pushes = system.asked<boolean>('pushes');
  const idle = models.find((model) => isIdle(model, emitter, pushes));
  system.reportWhile(idle !== undefined, {
    code: 'idle-force',
    severity: 'warning',
    attribute: 'physics',
    value: idle?.type.name,
    used: 'no push',
    message: `${system.label}: its ${idle?.type.name} moves nothing: particles take a mass from their ${emitter?.type.name}, and for the wind a surfaceArea`,
  });
  const collides = system.asked<boolean>('collides');
  system.reportWhile(pushes && !(collides && emitter?.mass !== 0) && !models.some(isWind), {
    code: 'idle-force',
    severity: 'warning',
    attribute: 'pushes',
    value: pushes,
    used: 'no push',
    message: `${system.label}: pushes without ${collides ? 'a mass at its emitter' : 'collides'}, and without a wind: no body is pushed`,
  });
}

const isWind = (model: ModelNode): boolean => model instanceof WindModelNode;

/** No force moves what has no mass, and no wind what it finds no area of; there may be bodies for it. */
function isIdle(model: ModelNode, emitter: EmitterNode | undefined, pushes: boolean): boolean {
  if (!emitter || model instanceof BoundedModelNode || (pushes && isWind(model))) return false;
  return emitter.mass === 0 || (isWind(model) && emitter.surfaceArea === 0);
}
