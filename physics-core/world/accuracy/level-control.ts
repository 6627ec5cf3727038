import { DEFAULT_LEVEL, levelNamed, type Level, type LevelName } from '../../dynamics/levels.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { jointSettings, levelOf, solverSettings } from './solver-settings.js';
import { costs, type FollowingLevel, type Verdict } from '../../effects/costs/effects.js';
import { contactSurface } from '../../effects/contacts/effects.js';
import { contacts } from '../../effects/effect/chunks.js';
import { NO_DEMANDS } from '../../effects/contacts/solver-demands.js';
import type { JointSettings, NodeWorld } from '../../nodes/node/node-world.js';
import { MOST_PARTS } from '../../solver/tolerances.js';

/** Detail of the event `accuracy`: the level in force is another. */
export interface AccuracyChange {
  level: LevelName;
  from: LevelName;
  /** `asked`: by its author. The others: by `auto`, whose frames took so long. */
  because: 'asked' | Verdict['because'];
  /** Milliseconds that nine in ten of the last 60 frames stayed below. */
  p90?: number;
}

/** Told before steps change their length, seconds. */
type Lengthen = (from: number, to: number) => void;

/** The level in force, and what Bullet's solver works with at it. */
export class LevelControl {
  readonly #world: NodeWorld;
  readonly #lengthen: Lengthen;
  readonly #own: Level | undefined;
  /** Where it is left to itself. */
  #left: Level = levelNamed(DEFAULT_LEVEL);
  #auto: FollowingLevel | undefined;
  level: Level = levelNamed(DEFAULT_LEVEL);
  /** FALSE on the first collection freezes the world. */
  enabled = true;
  joints!: JointSettings;
  /** Into how many parts steps are split. */
  parts = 1;
  #told: Level | undefined;
  /** While it is carried out. */
  #verdict: Verdict | undefined;

  constructor(world: NodeWorld, lengthen: Lengthen, own?: Level) {
    this.#world = world;
    this.#lengthen = lengthen;
    this.#own = own;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    const world = this.#world;
    this.enabled = world.settings.asked('enabled');
    this.#setLevel(this.#own ?? levelOf(world.settings) ?? this.#left);
    const speed = world.settings.asked<number>('maxCorrectionSpeed');
    this.#limit(speed < 0 ? Infinity : speed);
    this.configureSolver();
    for (const node of world.nodes) if (isJoint(node)) node.updateCorrection();
  }

  /** How fast overlaps may be pushed apart, m/s. */
  #limit(speed: number): void {
    const { registry: effects, settings } = this.#world;
    const limited = speed < Infinity && contacts.here;
    const surface = limited ? effects.get(contactSurface) : effects.find(contactSurface);
    surface?.limit(settings, speed);
  }

  #setLevel(level: Level): void {
    if (level === this.level) return;
    this.#lengthen(this.level.timeStep, level.timeStep);
    this.level = level;
    // Where it is left to itself it goes on from here.
    if (!this.#verdict) this.#leave(level);
  }

  /** Seconds of one step of Bullet. */
  get partOfStep(): number {
    return this.level.timeStep / this.parts;
  }

  /** Splits the step that begins: a power of two, so that what depends on its length seldom is another. */
  split(parts: number): number {
    // Logarithms are as each browser has them.
    let now = 1;
    while (now < parts && now < MOST_PARTS) now *= 2;
    if (now === this.parts) return now;
    this.parts = now;
    this.configureSolver();
    for (const node of this.#world.nodes) if (isJoint(node)) node.lengthenSteps();
    return now;
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
    const { settings, bullet, registry: effects } = this.#world;
    this.joints = jointSettings(settings, this.level, this.partOfStep);
    bullet.configure(
      solverSettings(
        settings,
        this.level,
        this.partOfStep,
        effects.find(contactSurface)?.demands ?? NO_DEMANDS,
      ),
    );
  }

  // ---- auto -------------------------------------------------------------------------------------------------------

  /** Where the level is left to itself, it begins at this one; steps are split into so many parts, until one asks for others. */
  begin(name: LevelName = DEFAULT_LEVEL, parts = 1): void {
    this.parts = parts;
    this.#leave(levelNamed(name));
  }

  #leave(level: Level): void {
    this.#left = level;
    this.#auto?.begin(level);
  }

  /** A frame that stood for `seconds` took `ms`. */
  noteFrame(ms: number, seconds: number): void {
    const { settings } = this.#world;
    if (levelOf(settings)) return;
    if (!this.#auto) {
      this.#auto = costs.code.autoLevel();
      this.#auto.begin(this.#left);
    }
    const verdict = this.#auto.note(ms, seconds, settings.asked('timeBudget'));
    if (verdict) this.obey(verdict);
  }

  /** Goes to the level that frames ask for, here or where they are taken. */
  obey(verdict: Verdict): void {
    this.#verdict = verdict;
    this.#left = verdict.level;
    if (this.#auto) this.#auto.level = verdict.level;
    this.#world.events.during(this.#carryOut);
  }

  readonly #carryOut = (): void => {
    this.#world.configure();
    this.tell();
    this.#verdict = undefined;
  };
}
