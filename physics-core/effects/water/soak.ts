import { hypot } from '../../base/exact/index.js';
import type { Volume } from './volume.js';

/** Particles of one kind: balls. */
export interface Drops {
  /** So many numbers of each, first where it is and how it moves; and how many there are. */
  readonly motion: Float64Array;
  readonly stride: number;
  readonly count: number;
  /** 1: it lies, and is left alone. */
  readonly still: ArrayLike<number>;
  /** Of each, kg and metres. */
  readonly mass: number;
  readonly radius: number;
}

const point = new Float64Array(3);
const speed = new Float64Array(3);
const gain = new Float64Array(3);

/**
 * What `dt` seconds in water do to particles: what is lighter rises, and all are braked by it as bodies are. A speed is
 * taken that drag itself leaves at the end of that time, so that what is light comes to its terminal speed and never beyond;
 * and a way that goes by the mean of the speeds at both ends.
 */
export function soak(drops: Drops, volumes: readonly Volume[], dt: number): void {
  const { motion, stride, mass, radius } = drops;
  if (!(mass > 0) || !(radius > 0)) return;
  for (let k = 0; k < drops.count; k++) {
    if (drops.still[k] === 1) continue;
    const at = stride * k;
    for (let i = 0; i < 3; i++) point[i] = motion[at + i]!;
    const around = volumeAround(volumes, radius);
    if (!around) continue;
    brake(drops, at + 3, around, dt);
    for (let i = 0; i < 3; i++) motion[at + i] = motion[at + i]! + (gain[i]! * dt) / 2;
  }
}

/** The densest that a ball there is in. */
function volumeAround(volumes: readonly Volume[], radius: number): Volume | undefined {
  let densest: Volume | undefined;
  for (const volume of volumes) {
    if (volume.above(point) <= -radius || volume.bottomAbove(point) >= 0) continue;
    if (densest && volume.settings.density <= densest.settings.density) continue;
    if (volume.surrounds(point)) densest = volume;
  }
  return densest;
}

function brake({ motion, mass, radius }: Drops, at: number, volume: Volume, dt: number): void {
  const { density, drag, damping, flow } = volume.settings;
  const share = shareBelow(volume.above(point) / radius);
  const area = share * Math.PI * radius * radius;
  /** Of the water in its place, by what it weighs itself. */
  const displaced = (density * area * radius * 4) / 3 / mass;
  for (let i = 0; i < 3; i++)
    speed[i] = motion[at + i]! - flow[i]! - displaced * volume.gravity[i]! * dt;
  const slowed = 1 + damping * displaced * dt;
  const rush = (2 * density * drag * area * dt * hypot(speed[0]!, speed[1]!, speed[2]!)) / mass;
  // Of w u + k u² dt = u*, k being ½ ρ c A / m.
  const left = 2 / (slowed + Math.sqrt(slowed * slowed + rush));
  for (let i = 0; i < 3; i++) {
    const now = flow[i]! + left * speed[i]!;
    gain[i] = now - motion[at + i]!;
    motion[at + i] = now;
  }
}

/** Of a ball whose middle is so many of its radii below. */
function shareBelow(depth: number): number {
  const height = Math.min(2, Math.max(0, 1 + depth));
  return (height * height * (3 - height)) / 4;
}
