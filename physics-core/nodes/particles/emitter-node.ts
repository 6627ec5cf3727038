import { Draws } from '../../effects/particles/emit/draws.js';
import { BIRTH, type Emitter, type Speeds } from '../../effects/particles/emit/emitter.js';
import { PartNode } from './part-node.js';

/** An X3DParticleEmitterNode. */
export abstract class EmitterNode extends PartNode {
  #law: Emitter | undefined;
  #bears: boolean | undefined;

  /** How particles are born, as its fields say now. */
  get emitter(): Emitter {
    return (this.#law ??= this.law());
  }

  /** Whether there is anywhere that particles may be born. */
  get bears(): boolean {
    return (this.#bears ??= this.emitter.emit(new Draws(0).of(0), new Float64Array(BIRTH)));
  }

  protected abstract law(): Emitter;

  override changed(): void {
    this.#law = this.#bears = undefined;
    super.changed();
  }

  /** Its field `on`: nodes have a method of that name. */
  get emits(): boolean {
    return this.asked('on');
  }

  /** All are born at once, when it begins, and none after that. */
  get atOnce(): boolean {
    return false;
  }

  /** Of each particle, kilograms. */
  get mass(): number {
    return this.asked('mass');
  }

  /** Of each particle, m². */
  get surfaceArea(): number {
    return this.asked('surfaceArea');
  }

  protected get speeds(): Speeds {
    return { speed: this.asked('speed'), variation: this.asked('variation') };
  }
}
