import { PARTICLE } from '../../effects/particles/cloud.js';
import { MOST_PARTICLES } from '../../effects/particles/budget.js';
import { particles } from '../../effects/particles/effects.js';
import type { Surface } from '../../effects/particles/surface.js';
import type { ParticleSystem } from '../../effects/particles/particle-system.js';
import type { ParticleSource } from '../../effects/particles/particles.js';
import type { Seen } from '../../effects/particles/seen.js';
import type { Settings } from '../../effects/particles/settings.js';
import { add } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../body/body.js';
import { PhysicsNode } from '../node/node.js';
import type { EmitterNode } from './emitter-node.js';
import { tellIdle } from './idle.js';
import { BoundedModelNode, ForceModelNode, WindModelNode, type ModelNode } from './model-node.js';
import { wallsOf } from './walls.js';

const NOTHING: Vec3 = [0, 0, 0];

/** What was removed, or can't be made, still stands where it was named. */
const standing = <N extends PhysicsNode>(node: N | null): N | undefined =>
  node?.built ? node : undefined;

const acts = (model: ModelNode): boolean => model.built && model.enabled;

/** Particles that an emitter bears and models move. */
export class ParticleSystemNode extends PhysicsNode implements ParticleSource {
  get #system(): ParticleSystem | undefined {
    return this.world.registry.find(particles)?.of(this);
  }

  // ---- what its author says ---------------------------------------------------------------------------------------

  get settings(): Settings {
    const emitter = standing(this.asked<EmitterNode | null>('emitter'));
    const body = this.asked<BodyNode | null>('body') ?? undefined;
    const models = this.asked<ModelNode[]>('physics').filter((model) => acts(model));
    const winds = models.flatMap((model) => (model instanceof WindModelNode ? [model.wind] : []));
    const pushes = this.asked<boolean>('pushes');
    const enabled = this.asked<boolean>('enabled');
    tellIdle(this, emitter, models);
    return {
      enabled,
      creates: this.asked<boolean>('createParticles') && emitter?.emits === true,
      most: this.asked('maxParticles'),
      lifetime: this.asked('particleLifetime'),
      lifetimeVariation: this.asked('lifetimeVariation'),
      seed: this.asked('seed'),
      damping: this.asked('damping'),
      emitter: emitter?.bears ? emitter.emitter : undefined,
      atOnce: emitter?.atOnce === true,
      mass: emitter?.mass ?? 0,
      surfaceArea: emitter?.surfaceArea ?? 0,
      radius: Math.min(...this.asked<[number, number]>('particleSize')) / 2,
      force: models.reduce(
        (sum, model) => (model instanceof ForceModelNode ? add(sum, model.force) : sum),
        NOTHING,
      ),
      winds,
      blows: enabled && pushes && winds.length > 0,
      surface: this.#surfaceOf(models, pushes ? (emitter?.mass ?? 0) : 0),
      body,
    };
  }

  /** `mass`: by which each particle pushes bodies, kg. */
  #surfaceOf(models: readonly ModelNode[], mass: number): Surface | undefined {
    const bodies = this.asked<boolean>('collides');
    const walls = wallsOf(models.filter((model) => model instanceof BoundedModelNode));
    if (!bodies && !walls) return undefined;
    const size = this.asked<[number, number]>('particleSize');
    return {
      bodies,
      mass: bodies ? mass : 0,
      walls,
      radius: Math.min(...size) / 2,
      bounce: this.asked('bounce'),
      friction: this.asked('friction'),
    };
  }

  /** What it says acts from the next step on. */
  changed(): void {
    this.world.registry.find(particles)?.changed();
  }

  protected override create(): boolean {
    this.world.registry.get(particles).need(this, 'a ParticleSystem');
    return true;
  }

  protected override destroy(): void {
    this.world.registry.find(particles)?.release(this);
  }

  /** For who draws them. */
  get shown(): Seen | undefined {
    return this.#system?.seen;
  }

  // ---- what it shows ----------------------------------------------------------------------------------------------

  get isActive(): boolean {
    return this.#system?.active ?? false;
  }

  /** How many live. */
  get count(): number {
    const { shown } = this;
    return shown ? shown.cloud.count - shown.first : 0;
  }

  /** Where they are, the oldest first, metres. */
  get positions(): Vec3[] {
    const { shown } = this;
    if (!shown) return [];
    const { cloud, first } = shown;
    return Array.from({ length: cloud.count - first }, (_, k): Vec3 => {
      const at = (first + k) * PARTICLE;
      return [cloud.motion[at]!, cloud.motion[at + 1]!, cloud.motion[at + 2]!];
    });
  }

  #crowded = false;

  #tellCrowded(crowded: boolean): void {
    this.#crowded = crowded;
    this.reportWhile(crowded, {
      code: 'out-of-range',
      severity: 'warning',
      attribute: 'maxParticles',
      value: this.asked('maxParticles'),
      used: this.count,
      message: `${this.label}: at most ${MOST_PARTICLES} particles live in a world at once, in all of its systems: none is born here until others have died`,
    });
  }

  /** What isActive said last, whatever became of the world since; undefined: nobody knows here. */
  #told: boolean | undefined = false;

  tellAnew(): void {
    this.#told = undefined;
  }

  stepped(active: boolean, crowded: boolean): void {
    // An edit of maxParticles takes it back: it is told again where that is still so.
    if (crowded || this.#crowded) this.#tellCrowded(crowded);
    if (active === this.#told) return;
    this.#told = active;
    this.emit('isActive', active);
  }

  /** Where its steps are taken, nobody knows what was told here before. */
  override toldElsewhere(event: string, detail: unknown): boolean {
    if (event !== 'isActive') return true;
    const news = detail !== this.#told;
    this.#told = detail as boolean;
    return news;
  }
}
