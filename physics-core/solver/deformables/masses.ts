/** Points that have mass, in flat arrays: what cloth and soft bodies are made of. Metres, kg, m/s; x, y, z of each. */
export class Masses {
  readonly count: number;
  readonly masses: Float64Array;
  /** 1/kg; 0: it stays where it is, or goes where others take it. */
  readonly inverse: Float64Array;
  readonly places: Float64Array;
  /** Where a part of a step began. */
  readonly before: Float64Array;
  readonly velocities: Float64Array;

  constructor(places: ArrayLike<number>) {
    this.count = Math.floor(places.length / 3);
    this.masses = new Float64Array(this.count);
    this.inverse = new Float64Array(this.count);
    this.places = Float64Array.from(places);
    this.before = Float64Array.from(places);
    this.velocities = new Float64Array(3 * this.count);
  }

  /** What each weighs now is what it is moved by, but for those that are held. */
  free(): void {
    for (let i = 0; i < this.count; i++)
      this.inverse[i] = this.masses[i]! > 0 ? 1 / this.masses[i]! : 0;
  }

  weigh(share: number): void {
    for (let i = 0; i < this.count; i++) this.masses[i]! *= share;
  }
}
