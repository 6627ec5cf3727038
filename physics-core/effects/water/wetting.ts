import { hypot } from '../../base/exact/index.js';
import { dot3 } from '../../base/flat-math.js';
import type { MassProperties } from '../../dynamics/body.js';
import { BELOW, CUT, PLANE, type Flat } from '../../shapes/cut/cut.js';
import type { BodyFrame } from './body-frame.js';
import type { BodyInWater } from './body-in-water.js';
import { Resistance } from './resistance.js';
import { SIX } from './six.js';
import type { Skin } from './skin.js';
import { MOST_LIFT } from './tolerances.js';
import type { Volume, WaterSource } from './volume.js';

const ROWS = SIX * SIX;

const surface = new Float64Array(4);
const floor = new Float64Array(4);
const cover = new Float64Array(4);
const below = new Float64Array(CUT);
const gravity = new Float64Array(3);
const flow = new Float64Array(3);
const seen = new Float64Array(SIX);
const push = new Float64Array(3);
const way = new Float64Array(3);
const thickness = { drag: 0, lift: 0 };

/** What all volumes of water together do to a body, in the axes of its centre of mass. */
export class Wetting {
  readonly #resistance = new Resistance();
  /** Newtons and newton metres that lift it. */
  readonly lift: Flat = new Float64Array(SIX);
  /** What brakes it: `resistance` times velocity and spin, but for what the water's flow takes from that. */
  readonly resistance: Flat = new Float64Array(ROWS);
  readonly drift: Flat = new Float64Array(SIX);
  /** m³ below surfaces, kg that this would weigh and that go along with it, and N/m by which surfaces push back. */
  volume = 0;
  mass = 0;
  addedMass = 0;
  stiffness = 0;
  /** kg of water that is moved by what it is braked by: Infinity where no surface moves. */
  column = Infinity;
  /** How far its lowest point is below the highest surface, metres, and how fast it sinks into that, m/s. */
  depth = 0;
  speed = 0;
  deepest!: WaterSource;

  clear(): void {
    this.lift.fill(0);
    this.resistance.fill(0);
    this.drift.fill(0);
    this.volume = this.mass = this.addedMass = this.stiffness = this.speed = 0;
    this.depth = -Infinity;
    this.column = Infinity;
  }

  /** Adds what a volume does to a body that reaches so far; `velocity`: of the body, as its resistance is reckoned with. */
  add(
    volume: Volume,
    shape: BodyInWater,
    mass: MassProperties,
    reach: number,
    frame: BodyFrame,
    velocity: Flat,
  ): void {
    const { cut, skin } = shape;
    const { centre } = frame;
    const { waves } = volume;
    const height = volume.above(centre);
    if (height + (waves ? waves.crest : 0) <= -reach || volume.bottomAbove(centre) >= reach) return;
    const share = volume.share(frame, skin, reach);
    if (!(share > 0)) return;
    writePlane(volume, height, frame, surface);
    const bottom = volume.bottomAbove(centre);
    const bounded = bottom > -reach;
    if (bounded) writePlane(volume, bottom, frame, floor);
    frame.inward(volume.settings.flow, 0, flow, 0);
    frame.inward(volume.gravity, 0, gravity, 0);
    waves?.meet(cut, share, frame, surface, gravity, flow);
    for (let k = 0; k < SIX; k++) seen[k] = velocity[k]! - (k < 3 ? flow[k]! : 0);
    const before = this.mass;
    const volumeBefore = this.volume;
    const covered = writeCover(volume, skin, reach, frame);
    this.#displace(volume, cut, surface, share);
    if (covered > 0) this.#displace(volume, cut, cover, -covered);
    if (bounded) this.#displace(volume, cut, floor, covered - share);
    waves?.displaced(this.volume - volumeBefore);
    if (waves) this.column = Math.min(this.column, waves.column * volume.settings.density);
    if (!(this.mass > before)) return;
    this.#look(volume, surface[PLANE.offset]! + skin.farthest(surface, -1), frame.velocity);
    this.#resist(volume, shape, share - covered, bounded ? floor : undefined);
    this.#resist(volume, shape, covered, cover);
    this.#damp(volume, this.mass - before, mass);
  }

  /** Of a body of so many kilograms: no more than that can be lifted by. */
  bound(mass: number): void {
    const share = (MOST_LIFT * mass) / this.mass;
    if (!(share < 1)) return;
    for (let k = 0; k < SIX; k++) this.lift[k] = this.lift[k]! * share;
    this.mass *= share;
    this.stiffness *= share;
  }

  /**
   * The water that brakes a body in a step of `dt` seconds is taken along by it meanwhile: the less of it there is, the less it
   * brakes, and never is it thrown beyond the body.
   */
  giveWay(dt: number): void {
    let most = 0;
    for (let k = 0; k < 3; k++) most = Math.max(most, this.resistance[7 * k]!);
    const share = 1 / (1 + (most * dt) / this.column);
    if (!(share < 1)) return;
    for (let i = 0; i < ROWS; i++) this.resistance[i] = this.resistance[i]! * share;
    for (let i = 0; i < SIX; i++) this.drift[i] = this.drift[i]! * share;
  }

  /** What displaces water is lifted by its weight, in the middle of what it displaces. */
  #displace(
    { settings, waves }: Volume,
    cut: BodyInWater['cut'],
    plane: Flat,
    share: number,
  ): void {
    cut.below(plane, below);
    const volume = share * below[BELOW.volume]!;
    const mass = settings.density * volume;
    this.volume += volume;
    this.mass += mass;
    this.addedMass += settings.addedMass * mass;
    for (let k = 0; k < 3; k++) push[k] = -settings.density * share * gravity[k]!;
    const stiffens = waves ? waves.stiffens : 1;
    this.stiffness += stiffens * Math.abs(dot3(push, 0, plane, 0)) * below[BELOW.area]!;
    const m = BELOW.moment;
    const lift = this.lift;
    for (let k = 0; k < 3; k++) {
      const i = (k + 1) % 3;
      const j = (k + 2) % 3;
      lift[k] = lift[k]! + push[k]! * below[BELOW.volume]!;
      lift[3 + k] = lift[3 + k]! + below[m + i]! * push[j]! - below[m + j]! * push[i]!;
    }
  }

  #look({ source }: Volume, depth: number, velocity: Flat): void {
    if (depth <= this.depth) return;
    this.deepest = source;
    this.depth = depth;
    this.speed = -dot3(velocity, 0, surface, 0);
  }

  /** Of such a share of what lies below the surface and above a floor. */
  #resist({ settings }: Volume, shape: BodyInWater, share: number, above: Flat | undefined): void {
    if (!(share > 0) || (settings.drag === 0 && settings.lift === 0)) return;
    const pressure = (share * settings.density * evennessOf(shape)) / 2;
    thickness.drag = pressure * settings.drag;
    thickness.lift = pressure * settings.lift;
    const matrix = this.#resistance.reckon(shape.skin, surface, above, seen, thickness);
    for (let i = 0; i < ROWS; i++) this.resistance[i] = this.resistance[i]! + matrix[i]!;
    for (let i = 0; i < SIX; i++) this.drift[i] = this.drift[i]! + dot3(matrix, SIX * i, flow, 0);
  }

  /** What floats has displaced its own mass, and loses that share of its speed and its spin. */
  #damp({ settings }: Volume, displaced: number, { mass, moments }: MassProperties): void {
    const rate = settings.damping * displaced;
    for (let k = 0; k < 3; k++) {
      this.resistance[7 * k] = this.resistance[7 * k]! + rate;
      this.resistance[7 * (3 + k)] = this.resistance[7 * (3 + k)]! + (rate * moments[k]!) / mass;
      this.drift[k] = this.drift[k]! + rate * flow[k]!;
    }
  }
}

/** As it goes through the water. */
function evennessOf(shape: BodyInWater): number {
  const speed = hypot(seen[0]!, seen[1]!, seen[2]!);
  if (speed === 0) return 1;
  for (let k = 0; k < 3; k++) way[k] = seen[k]! / speed;
  return shape.evenness(way);
}

function writePlane(volume: Volume, height: number, frame: BodyFrame, out: Flat): void {
  frame.inward(volume.up, 0, out, PLANE.normal);
  out[PLANE.offset] = height;
}

/** The surface of what is there instead, as far as that lies below its own; which share of a body is there. */
function writeCover(volume: Volume, skin: Skin, reach: number, frame: BodyFrame): number {
  let most = 0;
  for (const { volume: other, sides } of volume.covers) {
    const height = other.above(frame.centre);
    if (height <= -reach) continue;
    const share = volume.share(frame, skin, reach, sides);
    if (!(share > most)) continue;
    most = share;
    if (height < surface[PLANE.offset]!) writePlane(other, height, frame, cover);
    else cover.set(surface);
  }
  return most;
}
