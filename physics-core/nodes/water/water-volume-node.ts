import { quaternionOf, rotate } from '../../base/math.js';
import { water, waves } from '../../effects/water/effects.js';
import type { WaterSettings, WaveSettings } from '../../effects/water/settings.js';
import type { WaterSource } from '../../effects/water/volume.js';
import type { ShownSurface } from '../../effects/water/moving-surface.js';
import type { Vec3 } from '../../fields/types.js';
import { PhysicsNode } from '../node/node.js';

/** Water in which bodies float. */
export class WaterVolumeNode extends PhysicsNode implements WaterSource {
  #settings: WaterSettings | undefined;

  get settings(): WaterSettings {
    return (this.#settings ??= this.#read());
  }

  /** What its water weighs by, m/s². */
  get gravity(): Vec3 {
    return (this.collection ?? this.world.settings).asked('gravity');
  }

  #read(): WaterSettings {
    const q = quaternionOf(this.asked<number[]>('orientation'));
    return {
      enabled: this.asked('enabled'),
      pose: { p: this.asked('position'), q },
      size: this.asked('size'),
      density: this.asked('density'),
      drag: this.asked('dragCoefficient'),
      lift: this.asked('liftCoefficient'),
      damping: this.asked('damping'),
      addedMass: this.asked('addedMass'),
      flow: rotate(q, this.asked<Vec3>('flow')),
      waves: this.asked<boolean>('waves') ? this.#readWaves() : undefined,
    };
  }

  #readWaves(): WaveSettings {
    const [columns = 1, rows = columns] = this.asked<number[]>('subdivision');
    return {
      subdivision: [columns, rows],
      open: this.asked('edges') === 'OPEN',
      damping: this.asked('waveDamping'),
    };
  }

  /** What is in it, as plain data. */
  get inBullet(): Record<string, unknown> | undefined {
    return this.world.registry.find(water)?.knownOf(this);
  }

  /** What it says acts from the next step on. */
  changed(): void {
    this.#settings = undefined;
    this.#moveSurface();
    this.world.registry.find(water)?.changed();
  }

  #moveSurface(): void {
    const { registry } = this.world;
    const { enabled, waves: moves, size } = this.settings;
    if (enabled && moves && Math.min(...size) > 0) {
      const effect = registry.get(waves);
      if (effect.isNeededBy(this)) effect.changed(this);
      else effect.need(this, 'waves of a WaterVolume');
    } else registry.find(waves)?.release(this);
  }

  /** Its surface, where that moves: for who draws it. */
  get surface(): ShownSurface | undefined {
    return this.world.registry.find(waves)?.of(this)?.shown;
  }

  protected override create(): boolean {
    this.#settings = undefined;
    this.#moveSurface();
    this.world.registry.get(water).need(this, 'a WaterVolume');
    return true;
  }

  protected override destroy(): void {
    this.world.registry.find(waves)?.release(this);
    this.world.registry.find(water)?.release(this);
  }
}
