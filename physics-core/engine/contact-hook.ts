import type { Ammo } from './ammo.js';

/** Sees every contact point between Bullet's contact search and its solver. All three are heap pointers. */
export interface ContactProcessor {
  process(point: number, bodyA: number, bodyB: number): void;
}

type DynamicsWorld = Ammo['btDiscreteDynamicsWorld']['prototype'];

interface FunctionTable {
  addFunction(listener: (point: number, a: number, b: number) => number, signature: string): number;
}

/** Bullet has one contact callback for all worlds; it goes to the world that is stepping, and only if that asks for it. */
export class ContactHook {
  readonly #ammo: Ammo;
  #callback = 0;
  #processor: ContactProcessor | null = null;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** For the step that follows. Null takes the callback out of Bullet, so that it costs nothing. */
  listen(world: DynamicsWorld, processor: ContactProcessor | null): void {
    if (processor === this.#processor) return;
    this.#callback ||= (this.#ammo as unknown as FunctionTable).addFunction((point, a, b) => {
      this.#processor!.process(point, a, b);
      return 0;
    }, 'iiii');
    world.setContactProcessedCallback((processor ? this.#callback : 0) as never);
    this.#processor = processor;
  }
}
