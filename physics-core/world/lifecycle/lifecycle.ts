import { BulletWorld } from '../../engine/bullet-world.js';
import type { Engine } from '../../engine/engine.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import { threads } from '../../nodes/node/threads.js';
import type { BodySlots } from '../bodies/body-slots.js';
import { RANKS } from '../store/edits.js';
import type { LevelControl } from '../accuracy/level-control.js';
import type { Awaiting, Starting } from '../store/awaiting.js';
import type { Editing } from '../store/editing.js';
import type { ObstacleRules } from '../pairs/alone.js';
import type { Rays } from '../rays/raycast.js';
import { Readiness } from './readiness.js';
import type { Stepping } from '../stepping/stepping.js';

/** The world that starts and ends. */
interface LivingWorld extends NodeWorld {
  retelling(make: () => void): void;
  engine: Engine;
  bullet: BulletWorld;
  started: boolean;
  readonly bodies: BodySlots;
  readonly stepping: Stepping;
  readonly obstacles: ObstacleRules;
  readonly rays: Rays;
  readonly control: LevelControl;
  readonly edits: Editing;
  readonly awaiting: Awaiting;
}

/** How the Bullet world behind the nodes comes, begins anew, and goes. */
export class Lifecycle {
  readonly #world: LivingWorld;
  #ended = false;
  readonly ready = new Readiness<LivingWorld>();

  constructor(world: LivingWorld) {
    this.#world = world;
  }

  start(engine: Engine): void {
    const world = this.#world;
    if (world.started || world.awaiting.holds(world.nodes, this.#later(engine))) return;
    world.engine = engine;
    world.events.during(() => {
      this.#build();
      world.flush();
      this.#takeThread();
      this.ready.resolve(world);
      world.emit('ready', world);
      world.work();
    });
  }

  /** Once all code that its nodes need is here. */
  #later(engine: Engine): Starting {
    return {
      start: () => this.#ended || this.start(engine),
      failed: (problem) => this.ready.reject(problem),
    };
  }

  *starting(engine: Engine): Generator<void> {
    this.#world.engine = engine;
    this.#build();
    while (this.#world.edits.applyNext()) yield;
  }

  #build(): void {
    const world = this.#world;
    world.bullet = new BulletWorld(world.engine);
    world.started = true;
    world.awaiting.begin();
    world.configure();
    world.stepping.restart();
  }

  reset(): void {
    const world = this.#world;
    if (!world.started) return;
    world.flush();
    world.events.anew(() => {
      const tellWoken = world.bodies.sleepers();
      this.rebuild(() => {
        world.stepping.setTime(0);
        world.control.begin();
        for (const node of world.nodes) node.forgetEvents();
      });
      tellWoken();
      world.emit('reset', world);
    });
    this.#takeThread();
  }

  #takeThread(): void {
    if (threads.here) threads.code.choose(this.#world);
  }

  /** The same nodes in a fresh Bullet world. */
  rebuild(between: () => void): void {
    const world = this.#world;
    world.retelling(() => {
      world.registry.reset('reset');
      this.#unbuild();
      between();
      this.#build();
      for (const node of world.nodes) world.store.changed(node);
      world.flush();
    });
  }

  /** Newest first: joints before the bodies they hold. */
  #unbuild(): void {
    const world = this.#world;
    world.obstacles.clear();
    world.bodies.forgetSleep();
    const nodes = [...world.nodes].toReversed();
    for (let rank = RANKS - 1; rank >= 0; rank--) {
      for (const node of nodes) if (node.type.rank === rank) node.unmake();
    }
    world.rays.dispose();
    world.engine.solverHook.listen(null);
    world.engine.stages.listen(null);
    world.bullet.dispose();
    world.started = false;
  }

  destroy(): void {
    const world = this.#world;
    this.#ended = true;
    world.events.anew(() => {
      if (world.started) {
        world.registry.reset('removed');
        this.#unbuild();
      }
      for (const node of [...world.nodes]) node.remove();
    });
  }
}
