import { PARTICLE, type Cloud } from '../../effects/particles/cloud.js';
import { particles } from '../../effects/particles/effects.js';
import type { Surface } from '../../effects/particles/bounces.js';
import type { ParticleSystem } from '../../effects/particles/particle-system.js';
import type { ParticleSource } from '../../effects/particles/particles.js';
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

  /** For who draws them: its particles, those from `first` on alive, and the time of its system, seconds. */
  get shown(): { cloud: Cloud; first: number; time: number } | undefined {
    const system = this.#system;
    return (
      system && { cloud: system.cloud, first: system.cloud.count - system.count, time: system.time }
    );
  }

  // ---- what it shows ----------------------------------------------------------------------------------------------

  get isActive(): boolean {
    return this.#system?.active ?? false;
  }

  /** How many live. */
  get count(): number {
    return this.#system?.count ?? 0;
  }

  /** Where they are, the oldest first, metres. */
  get positions(): Vec3[] {
    const system = this.#system;
    if (!system) return [];
    const { count } = system;
    const { motion } = system.cloud;
    const first = system.cloud.count - count;
    return Array.from({ length: count }, (_, k): Vec3 => {
      const at = (first + k) * PARTICLE;
      return [motion[at]!, motion[at + 1]!, motion[at + 2]!];
    });
  }

  /** What isActive said last, whatever became of the world since. */
  #told = false;

  stepped(active: boolean): void {
    if (active === this.#told) return;
    this.#told = active;
    this.emit('isActive', active);
  }
}
