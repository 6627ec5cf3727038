import { LEAST_POISSON, MOST_DIVIDED, MOST_POISSON } from '../tolerances.js';
import { followed, type Elasticity } from './elasticity.js';
import { Hexahedra } from './hexahedra.js';
import { cellsOf, type Cells } from './lattice-cells.js';
import { Masses } from './masses.js';
import type { Material } from './material.js';
import { divided, volumeOf } from './divided.js';
import type { Surface } from './surface.js';
import { quickest } from './waves.js';

export interface LatticeSettings extends Elasticity {
  /** Of all of it, kg. */
  readonly mass: number;
  /** Cells along the longest side. */
  readonly resolution?: number;
}

/** Cells along the longest side, where nobody says how many. */
const RESOLUTION = 8;

/** A solid that gives way: what a closed surface encloses, as a lattice of box cells. Without any, it is no solid. */
export class Lattice implements Material {
  readonly masses: Masses;
  readonly surface: Surface;
  readonly lasting: Material['lasting'] = [];
  readonly strain = 0;
  /** How many cells it is made of. */
  readonly cells: number;
  readonly side: number;
  readonly solid: number;
  private readonly hexahedra: Hexahedra;
  private readonly rest: Float64Array;
  private readonly size: readonly number[];
  /** kg, of a cell that is covered, where all weigh 1 kg together. */
  private readonly cellMass: number;
  /** Its surface as it is laid, and the cells that carry it. */
  private readonly laid: readonly [points: ArrayLike<number>, index: ArrayLike<number>];
  private readonly carry: Cells['carry'];
  private divided: Surface | undefined;
  /** The square of the greatest frequency at rest of 1 kg, 1/s², and the share of it that hourglasses may have. */
  private square = 0;
  private youngsModulus = NaN;
  private poissonsRatio = NaN;
  private hourglassShare = 1;

  constructor(points: ArrayLike<number>, index: ArrayLike<number>, settings: LatticeSettings) {
    const cells = cellsOf(points, index, settings.resolution ?? RESOLUTION);
    this.cells = cells.count;
    this.size = cells.size;
    this.surface = cells.surface;
    this.laid = [points, cells.surface.triangles];
    this.carry = cells.carry;
    this.side = volumeOf(points, cells.surface.triangles) < 0 ? -1 : 1;
    this.rest = cells.places;
    this.masses = new Masses(cells.places);
    this.hexahedra = new Hexahedra(this.masses, cells);
    const covered = cells.cover.shares.reduce((sum, share) => sum + share, 0);
    this.cellMass = 1 / covered;
    this.solid = covered * cells.size.reduce((product, side) => product * side, 1);
    this.weigh(cells);
    this.masses.laid();
    this.masses.weigh(settings.mass);
    this.masses.free();
    this.surface.follow(this.masses);
    this.stiffen(settings);
  }

  /** Made for who asks for it first: nowhere longer than two cells, so that it bends as they do. */
  get hull(): Surface {
    if (this.divided) return this.divided;
    const { points, index } = divided(...this.laid, 2 * Math.min(...this.size), MOST_DIVIDED);
    this.divided = this.carry(points, index);
    this.divided.follow(this.masses);
    return this.divided;
  }

  /** What of a cell is covered is borne by its corners as if it were in its middle. */
  private weigh({ corners, cover }: Cells): void {
    const { masses } = this.masses;
    for (let i = 0; i < corners.length; i++) {
      let share = this.cellMass * cover.shares[i >> 3]!;
      for (let k = 0; k < 3; k++) {
        const middle = cover.middles[3 * (i >> 3) + k]!;
        share *= (1 + ((i >> k) & 1 ? middle : -middle)) / 2;
      }
      masses[corners[i]!]! += share;
    }
  }

  /** Another elasticity, at once. */
  stiffen({ youngsModulus, poissonsRatio }: Elasticity): void {
    const { hexahedra, masses } = this;
    const isAsWas = youngsModulus === this.youngsModulus && poissonsRatio === this.poissonsRatio;
    if (masses.count === 0 || isAsWas) return;
    this.youngsModulus = youngsModulus;
    this.poissonsRatio = poissonsRatio;
    hexahedra.stiffen(
      Math.max(0, youngsModulus),
      Math.min(MOST_POISSON, Math.max(LEAST_POISSON, poissonsRatio)),
    );
    hexahedra.soft = 1;
    const least = Math.min(...this.size);
    this.square = quickest(masses, this.rest, least, () => hexahedra.push(1));
    this.hourglassShare = hexahedra.hourglassShare(this.square, this.cellMass);
  }

  /** The square of the greatest frequency as heavy and as deformed as it is now, 1/s²: what is pressed flat is stiffer. */
  private frequencyNow(): number {
    const { mass } = this.masses;
    const square = mass > 0 ? this.square / mass : 0;
    return square > 0 ? square * this.hexahedra.stiffest(this.hourglassShare) : 0;
  }

  /** As it is deformed now: to be asked in each step. */
  parts(dt: number): number {
    return Math.max(1, Math.ceil(Math.sqrt(this.frequencyNow() / followed(dt))));
  }

  /** As it is deformed now, too. */
  soften(parts: number, dt: number): number {
    const square = this.frequencyNow();
    const most = followed(dt / parts);
    this.hexahedra.soft = square > most ? most / square : 1;
    return this.hexahedra.soft;
  }

  push(time: number): void {
    this.hexahedra.push(time);
  }

  hold(): void {
    // Forces are all there is.
  }
}
