import type { Line } from '../../shapes/geometry.js';
import { show } from '../../base/show.js';
import { levels } from '../../dynamics/levels.js';
import type { DragEnd, Hold } from '../../effects/drag/hold.js';
import { sightOfLine, type SoftSight } from '../../effects/drag/soft-places.js';
import { ropes } from '../../effects/soft/effects.js';
import type { Rope } from '../../effects/soft/rope.js';
import type { RopeSettings, RopeSource } from '../../effects/soft/settings.js';
import type { Value, Vec3 } from '../../fields/types.js';
import type { PhysicsNode } from '../node/node.js';
import { keptLine } from './line.js';
import { alongSegments } from './segments.js';
import { SoftNode } from './soft-node.js';

/** As plain data of a line. */
interface LineData {
  points?: number[];
}

/** A rope. */
export class RopeNode extends SoftNode implements RopeSource {
  override set(spelling: string, value: unknown, text: unknown = value): void {
    super.set(spelling, spelling === 'geometry' ? keptLine(value) : value, text);
  }

  override event(spelling: string, value: unknown): void {
    super.event(spelling, spelling === 'geometry' ? keptLine(value) : value);
  }

  override get(spelling: string): Value {
    const value = super.get(spelling);
    if (spelling !== 'geometry' || value === null) return value;
    return { type: 'LineSet', coord: (value as LineData).points ?? [] } satisfies Line;
  }

  /** What ties points of it. */
  readonly tiedBy = ropes;
  #tooStiff = false;

  get #rope(): Rope | undefined {
    return this.world.registry.find(ropes)?.of(this);
  }

  get settings(): RopeSettings {
    const stiffness = this.asked<number>('stretchStiffness');
    const collection = this.collection ?? this.world.settings;
    return {
      enabled: this.asked('enabled'),
      points: this.#points,
      mass: this.asked('mass'),
      radius: this.asked('radius'),
      softness: stiffness > 0 ? 1 / stiffness : 0,
      bending: this.asked('bendStiffness'),
      damping: this.asked('damping'),
      friction: this.asked('friction'),
      selfCollision: this.asked('selfCollision'),
      fixed: this.asked('fixedIndex'),
      gravity: collection.asked('gravity'),
      rests:
        collection.asked('rest') !== 'never' &&
        (collection.asked<boolean>('autoDisable') || !collection.authored('autoDisable')),
    };
  }

  get #points(): number[] {
    const own = this.asked<Vec3[]>('points').flat();
    const line = own.length > 0 ? own : (this.asked<LineData | null>('geometry')?.points ?? []);
    return alongSegments(line, this.asked('segments'));
  }

  /** Its gravity and rest are those of its collection. */
  override belongTo(collection: PhysicsNode | undefined): void {
    super.belongTo(collection);
    this.collectionChanged();
  }

  override collectionChanged(): void {
    if (!this.built) return;
    this.changed();
    this.updateDraggable();
  }

  changed(): void {
    this.#tellFixed();
    this.world.registry.find(ropes)?.changed(this);
  }

  #tellFixed(): void {
    const points = this.#points.length / 3;
    const beyond = this.asked<number[]>('fixedIndex').find((i) => i >= points);
    this.reportWhile(beyond !== undefined, {
      code: 'out-of-range',
      severity: 'warning',
      attribute: 'fixedIndex',
      value: beyond,
      used: 'nothing',
      message: `${this.label}: fixedIndex ${beyond} is no point of it: it has ${points}, counted from 0`,
    });
  }

  /** A line of one point is none. */
  protected override create(): boolean {
    const points = this.#points.length / 3;
    this.reportWhile(points < 2, {
      code: 'bad-value',
      severity: 'warning',
      attribute: 'points',
      value: points,
      used: 'nothing',
      message: `${this.label}: a rope takes a line of two points at least, and has ${points}: it is not there`,
    });
    if (points < 2) return false;
    this.world.registry.get(ropes).need(this, 'a Rope');
    return true;
  }

  protected override destroy(): void {
    super.destroy();
    this.world.registry.find(ropes)?.release(this);
  }

  protected override grab(point: Vec3, onend: (reason: DragEnd) => void): Hold | undefined {
    return this.world.registry.find(ropes)?.grab(this, point, onend);
  }

  protected override letGo(): void {
    this.world.registry.find(ropes)?.letGo(this);
  }

  protected override seenAt(places: Float64Array, sight: SoftSight): number | undefined {
    return sightOfLine(places, this.asked('radius'), sight);
  }

  /** Where its points are, metres, flat. */
  get places(): Float64Array | undefined {
    return this.#rope?.strand.places;
  }

  /** How fast they went there in the last step, m/s, flat. */
  get velocities(): Float64Array | undefined {
    return this.#rope?.strand.velocities;
  }

  /** Another number whenever they are elsewhere. */
  get moves(): number {
    return this.#rope?.version ?? 0;
  }

  get positions(): Vec3[] {
    const places = this.places ?? this.#points;
    return Array.from({ length: places.length / 3 }, (_, i): Vec3 => [
      places[3 * i]!,
      places[3 * i + 1]!,
      places[3 * i + 2]!,
    ]);
  }

  bends(most: number): void {
    const stiffness = this.asked<number>('bendStiffness');
    if (stiffness > most === this.#tooStiff) return;
    this.#tooStiff = stiffness > most;
    const { timeStep } = this.world;
    const needed = timeStep * Math.sqrt(most / stiffness);
    const level = levels.find((each) => each.timeStep <= needed);
    this.reportWhile(this.#tooStiff, {
      code: 'soft-too-stiff',
      severity: 'warning',
      attribute: 'bendStiffness',
      value: stiffness,
      used: most,
      message: `${this.label}: bendStiffness="${stiffness}" is more than steps of this accuracy follow: it bends as if it had ${show(most)} N m²; ${level ? `accuracy ${level.name} follows it` : 'longer or heavier links would'}`,
    });
  }

  stopped(): void {
    this.report({
      code: 'nan-state',
      severity: 'error',
      used: 'its last good place',
      message: `${this.label}: the simulation lost its numbers (NaN); it goes on from its last good place, at rest`,
    });
  }

  stepped(): void {
    if (this.heard('coord_changed')) this.emit('coord_changed', this.positions satisfies Value);
  }
}
