import { DEFAULT_LEVEL, levelNamed, type Level } from '../accuracy/levels.js';
import { JointNode } from '../nodes/joint.js';
import { jointSettings, levelOf, solverSettings, type JointSettings } from './solver-settings.js';
import type { World } from './world.js';

/** The level in force, and what Bullet's solver works with at it. */
export class Accuracy {
  readonly #world: World;
  readonly #own: Level | undefined;
  level: Level = levelNamed(DEFAULT_LEVEL);
  joints!: JointSettings;

  constructor(world: World, own?: Level) {
    this.#world = world;
    this.#own = own;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    const world = this.#world;
    this.#setLevel(this.#own ?? levelOf(world.settings));
    const speed = world.settings.asked<number>('maxCorrectionSpeed');
    world.registry.surface.limit(world.settings, speed < 0 ? Infinity : speed);
    this.configureSolver();
    world.compareCollections();
    for (const node of world.nodes) if (node instanceof JointNode) node.updateCorrection();
  }

  #setLevel(level: Level): void {
    if (level === this.level) return;
    this.#world.stepping.newTimeStep();
    this.level = level;
  }

  configureSolver(): void {
    const { settings, bullet, registry } = this.#world;
    this.joints = jointSettings(settings, this.level);
    bullet.configure(solverSettings(settings, this.level, registry.surface.demands));
  }
}
