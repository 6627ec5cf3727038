import type { Flat, Form } from './form.js';

/** Its middle, and its radius around it. */
export class BallForm implements Form {
  readonly round: number;
  readonly cornered = false;
  readonly reach: number;

  constructor(radius: number) {
    this.round = this.reach = radius;
  }

  support(_direction: Flat, out: Flat): void {
    out[0] = out[1] = out[2] = 0;
  }

  facing(): number {
    return -1;
  }

  face(): number {
    return 0;
  }

  lying(_x: number, _y: number, _z: number, _u: number, _v: number, _w: number, out: Flat): number {
    out[0] = out[1] = out[2] = 0;
    return 1;
  }

  line(_x: number, _y: number, _z: number, out: Flat): number {
    this.support(out, out);
    return 1;
  }
}
