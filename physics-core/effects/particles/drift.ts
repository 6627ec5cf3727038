import { exp } from '../../base/exact/index.js';
import { expm1 } from '../../base/exact/expm1.js';

/** Below this the series is exact to the last digit, and the quotient no more: found by comparing both. */
const SMALL = 0.1;

/** How many terms that takes. */
const TERMS = 12;

/** ∫ of e^(-z s) over s from 0 to 1. */
const meanLeft = (z: number): number => -expm1(-z) / z;

/** ∫ of that from 0 to s, over s from 0 to 1: one half where nothing is lost. */
function meanWay(z: number): number {
  if (z > SMALL) return (1 - meanLeft(z)) / z;
  let sum = 0;
  let term = 0.5;
  for (let k = 3; k < 3 + TERMS; k++) {
    sum += term;
    term *= -z / k;
  }
  return sum;
}

/**
 * What a time does to what moves under a steady acceleration a and a drag -k v (Stokes): exactly, however long it is.
 * x += v · wayOfSpeed + a · wayOfPush; v = v · left + a · speedOfPush.
 */
export class Drift {
  left = 1;
  /** Seconds. */
  wayOfSpeed = 0;
  speedOfPush = 0;
  /** Seconds squared. */
  wayOfPush = 0;

  /** `damping`: k, 1/s. */
  take(damping: number, seconds: number): this {
    const z = damping * seconds;
    if (z === 0) return this.#takeFree(seconds);
    this.left = exp(-z);
    this.wayOfSpeed = this.speedOfPush = seconds * meanLeft(z);
    this.wayOfPush = seconds * seconds * meanWay(z);
    return this;
  }

  #takeFree(seconds: number): this {
    this.left = 1;
    this.wayOfSpeed = this.speedOfPush = seconds;
    this.wayOfPush = (seconds * seconds) / 2;
    return this;
  }
}
