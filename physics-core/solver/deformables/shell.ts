import { LEAST_POISSON, LEAST_VOLUME, MOST_SHELL_POISSON } from '../tolerances.js';
import { followed, type Elasticity } from './elasticity.js';
import { Masses } from './masses.js';
import type { Material } from './material.js';
import { Skin } from './skin.js';
import { Surface } from './surface.js';
import { quickest } from './waves.js';
import { finiteTriangles, skinOf } from './weld.js';

export interface ShellSettings extends Elasticity {
  /** Of all of it, kg. */
  readonly mass: number;
  /** Metres. */
  readonly thickness: number;
  /** Of the gas inside above what is outside, at the volume as laid, Pa. */
  readonly pressure: number;
}

/** Of a volume below this share of area^(3/2), or areas that add up to more than this share of all: it encloses nothing. */
const HOLLOW = 1e-6;

/** More triangles than this have their frequency by the bound of the single ones, which may be too great by a third. */
const MANY = 20_000;

/**
 * A closed surface as a thin skin that does not resist bending, and a gas in it, of which the pressure above the outside
 * times the volume stays what it was. Points that are laid twice are one. What is open or flat can hold no gas.
 */
export class Shell implements Material {
  readonly masses: Masses;
  readonly surface: Surface;
  readonly lasting: Material['lasting'] = [];
  readonly strain = 0;
  /** m³ that are enclosed, as laid; 0: none are. */
  readonly volume: number;
  private readonly skin: Skin;
  private readonly rest: Float64Array;
  /** Metres. */
  thickness = NaN;
  /** m², of all triangles. */
  private readonly area: number;
  /** 1: triangles look outward; -1: inward. */
  private readonly faces: number;
  private gas = 0;
  /** Of all pressure this share is left, for parts of a step that are too long for more. */
  private gasSoft = 1;
  private softened = false;
  /** Squares of frequencies of 1 kg, 1/s²: the greatest of all; and of the gas alone, which has but one. */
  private square = 0;
  private gasSquare = 0;
  /** The same, at most, of a skin that is folded in whatever way. */
  private single = 0;
  /** What makes squares of frequencies of the skin's `squares`, where all are the same, m²/s²; 0: not found yet. */
  private even = 0;

  constructor(points: ArrayLike<number>, index: ArrayLike<number>, settings: ShellSettings) {
    const all = finiteTriangles(points, index);
    const { places, triangles, carriers } = skinOf(points, all);
    this.rest = places;
    this.masses = new Masses(places);
    const shown = carriers.length > 0 ? all : [];
    this.surface = new Surface(shown, 1, carriers, new Float64Array(carriers.length).fill(1));
    this.surface.follow(this.masses);
    this.skin = new Skin(this.masses, triangles);
    this.area = this.skin.areas.reduce((sum, area) => sum + area, 0);
    for (let i = 0; i < triangles.length; i++)
      this.masses.masses[triangles[i]!]! += this.skin.areas[Math.floor(i / 3)]! / (3 * this.area);
    this.masses.laid();
    this.masses.weigh(settings.mass);
    this.masses.free();
    const within = triangles.length > 0 ? this.skin.volume() : 0;
    this.faces = within < 0 ? -1 : 1;
    this.volume = this.encloses(within) ? Math.abs(within) : 0;
    this.gas = this.volume > 0 ? settings.pressure : 0;
    this.stiffen(settings);
  }

  get hull(): Surface {
    return this.surface;
  }

  get side(): number {
    return this.volume > 0 ? this.faces : 0;
  }

  private encloses(volume: number): boolean {
    if (!(Math.abs(volume) > HOLLOW * this.area * Math.sqrt(this.area))) return false;
    const open = this.areaVectors().sum;
    return Math.sqrt(open.reduce((all, a) => all + a * a, 0)) < HOLLOW * this.area;
  }

  /** What each point has of the areas around it, m², as vectors; and their sum, which is none where the surface is closed. */
  private areaVectors(): { each: Float64Array; sum: number[] } {
    const { triangles } = this.skin;
    const { rest } = this;
    const each = new Float64Array(rest.length);
    const sum = [0, 0, 0];
    for (let t = 0; t < triangles.length; t += 3)
      for (let k = 0; k < 3; k++) {
        const l = (k + 1) % 3;
        const m = (k + 2) % 3;
        const side = (c: number, along: number): number =>
          rest[3 * triangles[t + c]! + along]! - rest[3 * triangles[t]! + along]!;
        const sixth = (side(1, l) * side(2, m) - side(1, m) * side(2, l)) / 6;
        for (let c = 0; c < 3; c++) each[3 * triangles[t + c]! + k]! += sixth;
        sum[k]! += 3 * sixth;
      }
    return { each, sum };
  }

  /** Pa above the outside, at the volume as laid. */
  get pressure(): number {
    return this.gas;
  }

  set pressure(pressure: number) {
    if (this.volume === 0 || pressure === this.gas) return;
    this.gas = pressure;
    this.find();
  }

  /** Another elasticity or thickness, at once. */
  stiffen({
    youngsModulus,
    poissonsRatio,
    thickness,
  }: Elasticity & Pick<ShellSettings, 'thickness'>): void {
    const { skin } = this;
    const poisson = Math.min(MOST_SHELL_POISSON, Math.max(LEAST_POISSON, poissonsRatio));
    const stiffness = (Math.max(0, youngsModulus) * thickness) / (1 - poisson * poisson);
    const isAsWas = stiffness === skin.stiffness && poisson === skin.poisson;
    if (isAsWas && thickness === this.thickness) return;
    this.thickness = thickness;
    skin.poisson = poisson;
    skin.stiffness = stiffness;
    this.find();
  }

  /** Finds how quickly it can follow, as laid. */
  private find(): void {
    const { masses, skin } = this;
    if (masses.count === 0) return;
    this.harden();
    this.even = 0;
    const { each } = this.areaVectors();
    let mobility = 0;
    masses.asLaid(() => {
      for (let j = 0; j < each.length; j++)
        mobility += each[j]! * each[j]! * masses.inverse[Math.floor(j / 3)]!;
    });
    this.gasSquare = this.gas > 0 ? (this.gas / this.volume) * mobility : 0;
    const most = skin.squares.reduce((all, square) => Math.max(all, square));
    this.single = most * this.perSquare() + this.gasSquare;
    this.square = this.single;
    if (skin.count > MANY) return;
    const length = Math.sqrt(this.area / skin.count);
    const found = quickest(masses, this.rest, length, () => skin.push(1, this.presses()));
    this.square = Math.min(this.single, found);
  }

  /**
   * Makes all triangles alike, as quick by themselves as one another, and finds how quick they are together: as quick as any
   * can be, of which none is quicker by itself than these.
   */
  private findEven(): void {
    const { masses, skin } = this;
    this.even = this.perSquare();
    if (skin.count > MANY) return;
    const mean = skin.squares.reduce((sum, square) => sum + square) / skin.count;
    for (let t = 0; t < skin.count; t++) skin.soft[t] = mean / skin.squares[t]!;
    const length = Math.sqrt(this.area / skin.count);
    const square = quickest(masses, this.rest, length, () => skin.push(1, 0));
    this.even = Math.min(this.even, square / mean);
  }

  /** What makes squares of frequencies of the skin's `squares`, of 1 kg, m²/s². */
  private perSquare(): number {
    const { skin } = this;
    return skin.stiffness * (1 + skin.poisson) * this.area;
  }

  private harden(): void {
    this.skin.soft.fill(1);
    this.gasSoft = 1;
    this.softened = false;
  }

  /** Pa, along the sides that triangles look to. */
  private presses(): number {
    const presses = this.faces * this.gas * this.gasSoft;
    if (!(this.gas > 0)) return presses;
    const share = Math.max(LEAST_VOLUME, (this.faces * this.skin.volume()) / this.volume);
    return presses / share;
  }

  /**
   * The square of the greatest frequency, stretched and pressed together as it is now, of 1 kg, 1/s².
   * Triangles that are folded on each other do not hinder one another: they are as quick as the quickest is by itself.
   */
  private frequencyNow(): number {
    const { gas, gasSoft, gasSquare, skin, single, square } = this;
    const more = this.presses() / (gasSoft * gas);
    const pressed = gas > 0 ? more * more * gasSquare : 0;
    skin.look();
    return Math.max((square + (single - square) * skin.crumpled) * skin.stiffest, pressed);
  }

  /** As it is deformed now: to be asked in each step. */
  parts(dt: number): number {
    if (this.masses.count === 0) return 1;
    const square = this.frequencyNow() / this.masses.mass;
    return Math.max(1, Math.ceil(Math.sqrt(square / followed(dt))));
  }

  /** As it is deformed now, too; triangle by triangle, so that a sliver makes nothing soft but itself. */
  soften(parts: number, dt: number): number {
    const { skin, gasSquare } = this;
    if (this.softened) this.harden();
    if (this.masses.count === 0) return 1;
    const most = followed(dt / parts) * this.masses.mass;
    const square = this.frequencyNow();
    if (square <= most) return 1;
    this.softened = true;
    if (this.even === 0) this.findEven();
    // The gas has its part of what can be followed, and the skin the rest; both less, as what is deformed now is quicker.
    const slower = most * (this.square / square);
    const quickest = skin.squares.reduce((all, each) => Math.max(all, each)) * this.even;
    const gasShare = gasSquare / (gasSquare + quickest);
    const left = (slower * (1 - gasShare)) / this.even;
    let all = 0;
    for (let t = 0; t < skin.count; t++) {
      skin.soft[t] = Math.min(1, left / skin.squares[t]!);
      all += skin.soft[t]! * skin.areas[t]!;
    }
    // As much less pressure as there is less skin to bear it: the shape stays.
    this.gasSoft = gasSquare > 0 ? Math.min(all / this.area, (slower * gasShare) / gasSquare) : 1;
    return all / this.area;
  }

  push(time: number): void {
    if (this.masses.count > 0) this.skin.push(time, this.presses());
  }

  hold(): void {
    // Forces are all there is.
  }
}
