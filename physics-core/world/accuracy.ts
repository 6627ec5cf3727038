import { AutoLevel, type Verdict } from './auto-level.js';
import { DEFAULT_LEVEL, levelNamed, type Level, type LevelName } from '../dynamics/levels.js';
import { JointNode } from '../nodes/joint.js';
import { jointSettings, levelOf, solverSettings, type JointSettings } from './solver-settings.js';
import type { World } from './world.js';

/** Detail of the event `accuracy`: the level in force is another. */
export interface AccuracyChange {
  level: LevelName;
  from: LevelName;
  /** `asked`: by its author. The others: by `auto`, whose frames took so long. */
  because: 'asked' | Verdict['because'];
  /** Milliseconds that nine in ten of the last 60 frames stayed below. */
  p90?: number;
}

/** The level in force, and what Bullet's solver works with at it. */
export class Accuracy {
  readonly #world: World;
  readonly #own: Level | undefined;
  readonly #auto = new AutoLevel();
  level: Level = levelNamed(DEFAULT_LEVEL);
  joints!: JointSettings;
  #told: Level | undefined;
  /** While it is carried out. */
  #verdict: Verdict | undefined;

  constructor(world: World, own?: Level) {
    this.#world = world;
    this.#own = own;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    const world = this.#world;
    this.#setLevel(this.#own ?? levelOf(world.settings) ?? this.#auto.level);
    const speed = world.settings.asked<number>('maxCorrectionSpeed');
    world.registry.surface.limit(world.settings, speed < 0 ? Infinity : speed);
    this.configureSolver();
    world.compareCollections();
    for (const node of world.nodes) if (node instanceof JointNode) node.updateCorrection();
  }

  #setLevel(level: Level): void {
    if (level === this.level) return;
    this.#world.stepping.newTimeStep(this.level.timeStep, level.timeStep);
    this.level = level;
    // Where it is left to itself it goes on from here.
    if (!this.#verdict) this.#auto.begin(level);
  }

  /** Says so where the level is another than it was said to be. A world that starts says nothing. */
  tell(): void {
    const from = this.#told;
    if (from === this.level) return;
    this.#told = this.level;
    if (!from) return;
    const { because = 'asked', p90 } = this.#verdict ?? {};
    const change: AccuracyChange = { level: this.level.name, from: from.name, because };
    this.#world.emit('accuracy', p90 === undefined ? change : { ...change, p90 });
  }

  configureSolver(): void {
    const { settings, bullet, registry } = this.#world;
    this.joints = jointSettings(settings, this.level);
    bullet.configure(solverSettings(settings, this.level, registry.surface.demands));
  }

  // ---- auto -------------------------------------------------------------------------------------------------------

  /** Where the level is left to itself, it begins at this one. */
  begin(name: LevelName = DEFAULT_LEVEL): void {
    this.#auto.begin(levelNamed(name));
  }

  /** A frame that stood for `seconds` took `ms`. */
  noteFrame(ms: number, seconds: number): void {
    const { settings } = this.#world;
    if (levelOf(settings)) return;
    this.#verdict = this.#auto.note(ms, seconds, settings.asked('timeBudget'));
    if (this.#verdict) this.#world.events.during(this.#carryOut);
  }

  readonly #carryOut = (): void => {
    this.#world.configure();
    this.tell();
    this.#verdict = undefined;
  };
}
