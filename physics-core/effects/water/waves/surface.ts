import { dot3 } from '../../../base/flat-math.js';
import type { Body } from '../../../dynamics/body.js';
import { BELOW, CUT, PLANE, type Flat } from '../../../shapes/cut/cut.js';
import type { Numbered } from '../../effect/effect.js';
import type { BodyFrame } from '../body-frame.js';
import type { CutBody } from '../cut-body.js';
import type { MovingSurface, ShownSurface, ToldSurface } from '../moving-surface.js';
import type { WaterSettings } from '../settings.js';
import { LOOKS, MOST_OF_FOOTPRINT, STILL, STIRS, WIDER } from '../tolerances.js';
import type { Volume } from '../volume.js';
import { WaveField, type Grid } from './field.js';
import { Footprint } from './footprint.js';
import { keepField, restoreField, standAgain, type KeptSurface } from './kept.js';
import { Stand } from './stand.js';

const ACROSS = 0;
const ALONG = 2;

const below = new Float64Array(CUT);
const normal = new Float64Array(3);
const middle = new Float64Array(3);
const axis = new Float64Array(3);

export type { KeptSurface };

/**
 * The surface of a volume of water, and what stands in it.
 *
 * What a body displaces goes into the heights around it, and when it moves on it comes along: only what changes stirs them.
 * The body is cut by the plane that has the height and the slope of the field there, weighed by its footprint, and not by
 * the one that fits best: by the same weights its water is lifted, so that neither gains energy out of nothing.
 */
export class WaveSurface implements MovingSurface {
  readonly field: WaveField;
  #volume: Volume;
  readonly #stands = new Map<Body, Stand>();
  readonly #under: Footprint;
  readonly #of = { body: undefined as Body | undefined, stand: undefined as Stand | undefined };
  stiffens = 1;
  column = Infinity;
  /** Nothing has stirred it since it was seen to be still. */
  asleep = true;
  /** It is there since this step: what is in it has not come into it. */
  #begins = true;
  #looked = 0;
  #version = 1;
  #shown: { version: number; heights: Float32Array } | undefined;

  constructor(volume: Volume) {
    this.#volume = volume;
    this.field = new WaveField(gridOf(volume.settings));
    this.#under = new Footprint(this.field);
    this.follow(volume);
  }

  /** Whether it is divided as a volume says. */
  fits({ settings }: Volume): boolean {
    const { columns, rows, width, length } = gridOf(settings);
    const { field } = this;
    return (
      field.columns === columns &&
      field.rows === rows &&
      field.width === width &&
      field.length === length
    );
  }

  /** Its volume is another now. */
  follow(volume: Volume): void {
    const { settings } = volume;
    const waves = settings.waves!;
    this.#volume = volume;
    this.field.conditions = {
      depth: settings.size[1],
      gravity: this.#gravity,
      open: waves.open,
      damping: waves.damping,
    };
    this.asleep = false;
  }

  /** Into the water, m/s². */
  get #gravity(): number {
    const { gravity, up } = this.#volume;
    return Math.max(0, -(gravity[0] * up[0] + gravity[1] * up[1] + gravity[2] * up[2]));
  }

  /** What weighs nothing has no surface. */
  get #acts(): boolean {
    return this.field.conditions.gravity > 0;
  }

  // ---- a step -----------------------------------------------------------------------------------------------------

  /** Before anything in it is pushed. */
  begin(dt: number): void {
    if (this.#gravity !== this.field.conditions.gravity) this.follow(this.#volume);
    if (!this.#acts) this.asleep = true;
    if (!this.asleep) this.#step(dt);
    for (const stand of this.#stands.values()) stand.met = stand.attended = false;
  }

  #step(dt: number): void {
    this.field.step(dt);
    for (const stand of this.#stands.values()) if (stand.met) this.#goOn(stand, dt);
    this.#version++;
    this.#wake();
    if (++this.#looked % LOOKS === 0 && this.field.isStill(STILL)) this.#sleep();
  }

  /**
   * What moves in it goes on as it did, until it is known how it does: what is near feels it in this very step. A step later
   * each would swing the other up.
   */
  #goOn(stand: Stand, dt: number): void {
    if (stand.isStill) return;
    this.#take(stand);
    stand.goOn(dt);
    this.#under.place(stand.stoodAcross, stand.stoodAlong, stand.stoodWidth, stand.stoodLength);
    this.#under.raise(stand.volume);
  }

  /** What rests in it rides on it all the same. */
  #wake(): void {
    for (const [body, stand] of this.#stands) {
      if (stand.gone || !body.sleeping) continue;
      this.#place(stand);
      this.#under.feel();
      if (Math.abs(this.#under.height - stand.height) > STILL) body.wake();
    }
  }

  #sleep(): void {
    this.asleep = true;
    this.field.calm(this.#volume.settings.waves!.open ? 0 : this.field.level);
  }

  attend(body: Body): void {
    const stand = this.#acts ? this.#stands.get(body) : undefined;
    this.#of.body = this.#acts ? body : undefined;
    this.#of.stand = stand;
    if (stand) stand.attended = true;
  }

  heightAt(across: number, along: number): number {
    return this.asleep ? 0 : this.field.heightAt(across, along);
  }

  get crest(): number {
    return Math.max(0, this.field.crest);
  }

  meet(
    cut: CutBody,
    share: number,
    frame: BodyFrame,
    plane: Flat,
    gravity: Flat,
    flow: Flat,
  ): void {
    const { body } = this.#of;
    this.stiffens = 1;
    this.column = Infinity;
    if (!body) return;
    const stand = (this.#of.stand ??= this.#add(body));
    const under = this.#under;
    stand.met = stand.attended = true;
    this.#follow(stand, body, frame);
    this.#place(stand);
    under.feel();
    under.feelFlow();
    stand.height = under.height;
    const above = this.#volume.above(frame.centre);
    this.#write(stand, above, frame, plane);
    cut.below(plane, below);
    // With what it displaces more than before its water rises, and with that again.
    // Next to nothing may be less than that, by rounding.
    const area = share * Math.max(0, below[BELOW.area]!);
    const lifts = under.area;
    this.column = lifts * this.field.conditions.depth;
    stand.share = Math.min(1, (MOST_OF_FOOTPRINT * lifts) / area);
    const gain = (stand.share * area) / lifts;
    this.stiffens = 1 / (1 - gain);
    const displaced = stand.share * (share * below[BELOW.volume]! - stand.cutOff);
    if (!this.#begins) stand.height += ((displaced - stand.volume) * this.stiffens) / lifts;
    this.#write(stand, above, frame, plane);
    cut.below(plane, below);
    stand.cut = share * below[BELOW.volume]!;
    this.#remember(stand, frame);
    this.#turn(frame, gravity, flow);
  }

  #add(body: Body): Stand {
    const stand = new Stand();
    this.#stands.set(body, stand);
    return stand;
  }

  #place({ across, along, width, length }: Stand): void {
    this.#under.place(across, along, width, length);
  }

  /** It is where the body is, aside by as much as its middle of buoyancy was. */
  #follow(stand: Stand, { mass, reach }: Body, frame: BodyFrame): void {
    const volume = this.#volume;
    stand.across = volume.along(ACROSS, frame.centre) + stand.acrossAside;
    stand.along = volume.along(ALONG, frame.centre) + stand.alongAside;
    stand.width = this.#extent(ACROSS, mass.mass, mass.moments, reach, frame);
    stand.length = this.#extent(ALONG, mass.mass, mass.moments, reach, frame);
  }

  /** How wide a box with such moments would be along an axis, and a little more. */
  #extent(
    which: typeof ACROSS | typeof ALONG,
    mass: number,
    moments: readonly [number, number, number],
    reach: number,
    frame: BodyFrame,
  ): number {
    frame.inward(this.#volume.axes[which], 0, axis, 0);
    const sum = moments[0] + moments[1] + moments[2];
    let square = 0;
    for (let k = 0; k < 3; k++) square += axis[k]! ** 2 * (sum - 2 * moments[k]!);
    return Math.min(2 * reach, WIDER * Math.sqrt((6 * Math.max(0, square)) / mass));
  }

  /** The plane that has that height under the stand, as the body's axes see it. */
  #write(stand: Stand, above: number, frame: BodyFrame, plane: Flat): void {
    const { acrossSlope, alongSlope } = this.#under;
    const { axes } = this.#volume;
    const upright = 1 / Math.sqrt(1 + acrossSlope ** 2 + alongSlope ** 2);
    for (let k = 0; k < 3; k++)
      normal[k] =
        upright * (axes[1][k]! - acrossSlope * axes[ACROSS][k]! - alongSlope * axes[ALONG][k]!);
    frame.inward(normal, 0, plane, PLANE.normal);
    const there = stand.height - acrossSlope * stand.acrossAside - alongSlope * stand.alongAside;
    plane[PLANE.offset] = upright * (above + there);
  }

  /** Where the middle of what it displaces is. */
  #remember(stand: Stand, frame: BodyFrame): void {
    const volume = below[BELOW.volume]!;
    if (!(volume > 0)) return;
    for (let k = 0; k < 3; k++) axis[k] = below[BELOW.moment + k]! / volume;
    frame.outward(axis, 0, middle, 0);
    stand.acrossAside = dot3(middle, 0, this.#axis(ACROSS), 0);
    stand.alongAside = dot3(middle, 0, this.#axis(ALONG), 0);
  }

  #axis(which: typeof ACROSS | typeof ALONG): Flat {
    for (let k = 0; k < 3; k++) axis[k] = this.#volume.axes[which][k]!;
    return axis;
  }

  /** What lies on a slope is pushed down it, and goes along with what flows there. */
  #turn(frame: BodyFrame, gravity: Flat, flow: Flat): void {
    const { acrossSlope, alongSlope, acrossFlow, alongFlow } = this.#under;
    const { depth, gravity: g } = this.field.conditions;
    this.#lean(frame, gravity, g * acrossSlope, g * alongSlope);
    this.#lean(frame, flow, acrossFlow / depth, alongFlow / depth);
  }

  #lean(frame: BodyFrame, out: Flat, across: number, along: number): void {
    const { axes } = this.#volume;
    for (let k = 0; k < 3; k++) middle[k] = across * axes[ACROSS][k]! + along * axes[ALONG][k]!;
    frame.inward(middle, 0, axis, 0);
    for (let k = 0; k < 3; k++) out[k] = out[k]! + axis[k]!;
  }

  displaced(volume: number): void {
    const { stand } = this.#of;
    if (!stand) return;
    stand.cutOff = stand.cut - volume;
    stand.now = volume;
  }

  answer(force: Flat, volume: number, dt: number): void {
    const { stand } = this.#of;
    if (!stand?.met) return;
    this.#stand(stand, stand.share * stand.now, dt);
    if (!(stand.now > 0)) return;
    const push = (-dt * stand.now) / volume / this.#volume.settings.density;
    const across = push * dot3(force, 0, this.#axis(ACROSS), 0);
    const along = push * dot3(force, 0, this.#axis(ALONG), 0);
    if (this.asleep) {
      const stirs = STIRS * this.field.speed * this.#under.area;
      if (Math.abs(across) < stirs && Math.abs(along) < stirs) return;
    }
    this.asleep = false;
    this.#under.push(across, along);
  }

  /** What stood there goes away, and what is displaced comes. */
  #stand(stand: Stand, volume: number, dt: number): void {
    this.#place(stand);
    if (this.#begins) return stand.begin(volume);
    if (this.asleep && !stand.stirs(volume, STIRS * this.#under.area)) return;
    this.asleep = false;
    this.#take(stand);
    this.#place(stand);
    this.#under.raise(volume);
    stand.take(volume, dt);
  }

  #take(stand: Stand): void {
    if (stand.volume === 0) return;
    this.#under.place(stand.stoodAcross, stand.stoodAlong, stand.stoodWidth, stand.stoodLength);
    this.#under.raise(-stand.volume);
  }

  /** All in it was pushed: what it did not meet has left it. */
  end(): void {
    this.#begins = false;
    for (const [body, stand] of this.#stands) {
      // What sleeps, or is carried no longer, stands where it was.
      if (stand.met || (!stand.gone && !stand.attended)) continue;
      this.#stands.delete(body);
      if (stand.volume === 0) continue;
      this.#take(stand);
      this.asleep = false;
    }
  }

  /** What stood for it in Bullet is gone. */
  unmade(body: Body): void {
    const stand = this.#stands.get(body);
    if (stand) stand.gone = true;
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  /** The world begins anew. */
  reset(): void {
    this.field.calm(0);
    this.#stands.clear();
    this.#begins = true;
    this.asleep = false;
    this.#looked = 0;
    this.#version++;
  }

  save(): KeptSurface {
    return {
      begins: this.#begins,
      asleep: this.asleep,
      looked: this.#looked,
      field: keepField(this.field, this.asleep),
      stands: [...this.#stands].map(([{ id }, stand]) => [id, { ...stand }]),
    };
  }

  load({ begins, asleep, looked, field, stands }: KeptSurface, nodes: Numbered): void {
    this.#begins = begins;
    this.asleep = asleep;
    this.#looked = looked;
    restoreField(this.field, field);
    this.#version++;
    this.#stands.clear();
    for (const [id, stand] of stands) {
      const body = nodes.body(id);
      if (body) this.#stands.set(body, standAgain(stand));
    }
  }

  // ---- what is seen -----------------------------------------------------------------------------------------------

  get shown(): ShownSurface {
    const { columns, rows, width, length, heights } = this.field;
    const shown = (this.#shown ??= { version: 0, heights: new Float32Array(heights.length) });
    if (shown.version !== this.#version) shown.heights.set(heights);
    shown.version = this.#version;
    return { columns, rows, width, length, ...shown };
  }

  /** Its steps are taken elsewhere. Divided otherwise there, it is not shown until it is told of anew. */
  hear({ version, heights }: ToldSurface): void {
    if (heights.length !== this.field.heights.length) return;
    this.#version = version;
    this.#shown = { version, heights };
  }
}

function gridOf({ size, waves }: WaterSettings): Grid {
  const [columns, rows] = waves!.subdivision;
  return { columns, rows, width: size[0], length: size[2] };
}
