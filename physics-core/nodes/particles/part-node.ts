import { particles } from '../../effects/particles/effects.js';
import { PhysicsNode } from '../node/node.js';

/** What stands in a ParticleSystem, and says how its particles are born or moved. */
export abstract class PartNode extends PhysicsNode {
  /** Systems read anew what they are made of, before the next step. */
  changed(): void {
    this.world.registry.find(particles)?.changed();
  }

  protected override released(): void {
    this.changed();
  }
}
