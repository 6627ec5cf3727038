import type { EmitterNode } from './emitter-node.js';
import { BoundedModelNode, type ModelNode } from './model-node.js';
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
  const pushing = models.find((model) => !(model instanceof BoundedModelNode));
  system.reportWhile(emitter?.mass === 0 && pushing !== undefined, {
    code: 'idle-force',
    severity: 'warning',
    attribute: 'physics',
    value: pushing?.type.name,
    used: 'no push',
    message: `${system.label}: no force and no wind moves particles without mass: its ${emitter?.type.name} takes a mass, and for the wind a surfaceArea`,
  });
}
