import type { WindSettings } from '../../effects/particles/settings.js';
import type { Vec3 } from '../../fields/types.js';
import type { Mesh } from '../../shapes/geometry.js';
import { meshOf } from './mesh.js';
import { PartNode } from './part-node.js';

/** An X3DParticlePhysicsModelNode. */
export abstract class ModelNode extends PartNode {
  get enabled(): boolean {
    return this.asked('enabled');
  }
}

export class ForceModelNode extends ModelNode {
  /** Newtons, on each particle. */
  get force(): Vec3 {
    return this.asked('force');
  }
}

export class WindModelNode extends ModelNode {
  get wind(): WindSettings {
    return {
      direction: this.asked('direction'),
      speed: this.asked('speed'),
      gustiness: this.asked('gustiness'),
      turbulence: this.asked('turbulence'),
    };
  }
}

export class BoundedModelNode extends ModelNode {
  /** What particles bounce off, as triangles. */
  get mesh(): Mesh {
    return meshOf(this.asked('geometry'));
  }
}
