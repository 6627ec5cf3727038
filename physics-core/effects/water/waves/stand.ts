/** How a body stands in a surface. */
export class Stand {
  /** Where its footprint is, from the middle of the volume, and how far it goes, metres. */
  across = 0;
  along = 0;
  width = 0;
  length = 0;
  /** From its centre of mass to the middle of what it displaces, metres. */
  acrossAside = 0;
  alongAside = 0;
  /** Of the surface there, metres above the still water. */
  height = 0;
  /** m³ below its surface, those of them that displace nothing of this water, and those that do. */
  cut = 0;
  cutOff = 0;
  now = 0;
  /** Which share of that the heights get. */
  share = 1;
  /** m³ of it that stand in the heights, and where they do. */
  volume = 0;
  stoodAcross = 0;
  stoodAlong = 0;
  stoodWidth = 0;
  stoodLength = 0;
  /** What stood there and where at the end of the last step, and how that changes: m³/s and m/s. */
  wasVolume = 0;
  wasAcross = 0;
  wasAlong = 0;
  rise = 0;
  acrossSpeed = 0;
  alongSpeed = 0;
  /** It was pushed in this step; it is gone. */
  met = false;
  /** It was looked for in this step. */
  attended = false;
  gone = false;

  /** Whether to stand there with so many m³ changes anything by so many m³. */
  stirs(volume: number, least: number): boolean {
    const aside =
      Math.abs(this.across - this.stoodAcross) / this.width +
      Math.abs(this.along - this.stoodAlong) / this.length;
    return Math.abs(volume - this.volume) > least || aside * volume > least;
  }

  get isStill(): boolean {
    return this.rise === 0 && this.acrossSpeed === 0 && this.alongSpeed === 0;
  }

  /** It stands where it would if it went on as in the step before. */
  goOn(dt: number): void {
    this.volume += this.rise * dt;
    this.stoodAcross += this.acrossSpeed * dt;
    this.stoodAlong += this.alongSpeed * dt;
  }

  /** So many m³ of it stand in the heights where it is, and nothing is known of how that changes. */
  begin(volume: number): void {
    this.volume = this.wasVolume = volume;
    this.stoodAcross = this.wasAcross = this.across;
    this.stoodAlong = this.wasAlong = this.along;
    this.stoodWidth = this.width;
    this.stoodLength = this.length;
    this.rise = this.acrossSpeed = this.alongSpeed = 0;
  }

  /** So many m³ of it stand there at the end of a step. */
  take(volume: number, dt: number): void {
    const { wasVolume, wasAcross, wasAlong } = this;
    this.begin(volume);
    if (wasVolume === 0) return;
    this.rise = (volume - wasVolume) / dt;
    this.acrossSpeed = (this.across - wasAcross) / dt;
    this.alongSpeed = (this.along - wasAlong) / dt;
  }
}
