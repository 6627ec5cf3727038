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
  /** kg of each, where all weigh 1 kg together. */
  #shares: Float64Array;
  #mass = 1;

  constructor(places: ArrayLike<number>) {
    this.count = Math.floor(places.length / 3);
    this.masses = new Float64Array(this.count);
    this.inverse = new Float64Array(this.count);
    this.places = Float64Array.from(places);
    this.before = Float64Array.from(places);
    this.velocities = new Float64Array(3 * this.count);
    this.#shares = this.masses;
  }

  /** kg, of all. */
  get mass(): number {
    return this.#mass;
  }

  /** Each has its share of 1 kg. */
  laid(): void {
    this.#shares = this.masses.slice();
    this.free();
  }

  /** What each weighs now is what it is moved by, but for those that are held. */
  free(): void {
    for (let i = 0; i < this.count; i++)
      this.inverse[i] = this.masses[i]! > 0 ? 1 / this.masses[i]! : 0;
  }

  /** kg of all: by the same numbers, whatever it weighed before. */
  weigh(mass: number): void {
    this.#mass = mass;
    for (let i = 0; i < this.count; i++) this.masses[i] = mass * this.#shares[i]!;
  }

  /** `look` sees 1 kg, every point of it free; everything is put back after that. */
  asLaid(look: () => void): void {
    const { places, velocities, inverse } = this;
    const mass = this.#mass;
    const kept = [places.slice(), velocities.slice(), inverse.slice()] as const;
    this.weigh(1);
    this.free();
    look();
    this.weigh(mass);
    places.set(kept[0]);
    velocities.set(kept[1]);
    inverse.set(kept[2]);
  }
}
