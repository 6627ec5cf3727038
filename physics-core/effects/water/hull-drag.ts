import { grown } from '../../base/grown.js';
import type { Braking } from './braking.js';
import type { WetSurface } from './matter.js';
import type { WaterSettings } from './settings.js';
import { measure, normal, sizeOf } from './triangle.js';
import type { Volume } from './volume.js';

const speed = new Float64Array(3);

/** What brakes a surface of triangles: by the speed of each through the water, as of a body's skin. */
export class HullDrag {
  /** Of the points of its hull: m/s; kg/s; the same of lift, as vectors; and where the water goes there, with what weight. */
  #speeds = new Float64Array(0);
  #drags = new Float64Array(0);
  #lifts = new Float64Array(0);
  #flows = new Float64Array(0);
  #weights = new Float64Array(0);

  clear(count: number): void {
    if (this.#drags.length < count) {
      this.#speeds = grown(this.#speeds, 3 * count);
      this.#lifts = grown(this.#lifts, 3 * count);
      this.#flows = grown(this.#flows, 3 * count);
      this.#drags = grown(this.#drags, count);
      this.#weights = grown(this.#weights, count);
    }
    this.#lifts.fill(0);
    this.#flows.fill(0);
    this.#drags.fill(0);
    this.#weights.fill(0);
  }

  /** How fast each point of its hull is now. */
  look({ masses, hull }: WetSurface): void {
    const { width, carriers, shares, count } = hull;
    const { velocities } = masses;
    const speeds = this.#speeds;
    for (let i = 0, n = 0; i < count; i++) {
      let x = 0;
      let y = 0;
      let z = 0;
      for (const end = n + width; n < end; n++) {
        const share = shares[n]!;
        const j = 3 * carriers[n]!;
        x += share * velocities[j]!;
        y += share * velocities[j + 1]!;
        z += share * velocities[j + 2]!;
      }
      speeds[3 * i] = x;
      speeds[3 * i + 1] = y;
      speeds[3 * i + 2] = z;
    }
  }

  /** What is wet of it, at each corner of each triangle, is braked by a volume. */
  resist({ hull, side }: WetSurface, { settings }: Volume, wet: Float64Array): void {
    const { drag, lift, density, flow } = settings;
    const { places, triangles } = hull;
    if (drag === 0 && lift === 0) return;
    for (let n = 0; n + 2 < triangles.length; n += 3) {
      const area = wet[n]! + wet[n + 1]! + wet[n + 2]!;
      if (!(area > 0)) continue;
      measure(places, triangles[n]!, triangles[n + 1]!, triangles[n + 2]!);
      const size = sizeOf(normal);
      for (let k = 0; k < 3; k++) {
        speed[k] = -flow[k]!;
        for (let c = 0; c < 3; c++)
          speed[k]! += (wet[n + c]! * this.#speeds[3 * triangles[n + c]! + k]!) / area;
      }
      const along =
        (speed[0]! * normal[0]! + speed[1]! * normal[1]! + speed[2]! * normal[2]!) / size;
      // Of what is closed the front and the back, half each: what breathes is not driven by what brakes one of them alone.
      const against = side === 0 ? Math.abs(along) : Math.abs(along) / 2;
      if (!(against > 0)) continue;
      const press = (density * against) / 2;
      const turn = (lift * Math.sign(along)) / size / sizeOf(speed);
      for (let c = 0; c < 3; c++)
        this.#brake(triangles[n + c]!, wet[n + c]! * press, settings, turn);
    }
  }

  #brake(i: number, press: number, { drag, lift, flow }: WaterSettings, turn: number): void {
    const weight = press * (drag + lift);
    this.#drags[i]! += press * drag;
    this.#weights[i]! += weight;
    for (let k = 0; k < 3; k++) {
      const l = (k + 1) % 3;
      const m = (k + 2) % 3;
      this.#flows[3 * i + k]! += weight * flow[k]!;
      this.#lifts[3 * i + k]! += press * turn * (speed[l]! * normal[m]! - speed[m]! * normal[l]!);
    }
  }

  /** To those that carry it. */
  spread({ hull }: WetSurface, braking: Braking): void {
    const { width, carriers, shares, count } = hull;
    const { drags, weights, lifts, flows } = braking;
    for (let i = 0, n = 0; i < count; i++) {
      const weight = this.#weights[i]!;
      if (weight === 0) n += width;
      else
        for (const end = n + width; n < end; n++) {
          const share = shares[n]!;
          const c = carriers[n]!;
          drags[c]! += share * this.#drags[i]!;
          weights[c]! += share * weight;
          for (let k = 0; k < 3; k++) {
            lifts[3 * c + k]! += share * this.#lifts[3 * i + k]!;
            flows[3 * c + k]! += share * this.#flows[3 * i + k]!;
          }
        }
    }
  }
}
