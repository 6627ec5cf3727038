import { grown, grownInt } from '../../base/grown.js';

// The contacts of a step as rows of numbers: where each is, what it asks, and what is known of it while it is solved.

/** Places of a contact's numbers. Directions: the normal into A, and two along the surface. */
export const C = {
  normal: 0,
  direction1: 3,
  direction2: 6,
  /** From the centres of mass. */
  armA: 9,
  armB: 12,
  friction: 15,
  /** Speeds of A against B that it aims at, along the normal and both directions, m/s. */
  target: 16,
  /** What a miss of 1 m/s costs, kg. */
  penalty: 19,
  /** Impulses, N s: of the solution so far, and those that the velocities of now lead to. */
  impulse: 20,
  pushed: 23,
  /** By how much the speeds of now miss the targets, and how a change of velocities changes them. */
  miss: 26,
  change: 29,
  /** Speed along the surface times friction: what Coulomb's law has more than its associated form, m/s. */
  lift: 32,
  state: 33,
  /** Where it slides: the direction, and how much the push turns with it, N s per N s. */
  along1: 34,
  along2: 35,
  turning: 36,
  /** Overlap to be taken out in this step, metres. */
  overlap: 37,
  /** Whose corner it is that turns on the other (`CORNER`), where that is reckoned with. */
  corner: 38,
  /** How fast it wanders over that body, m/s: the place where something round is touched. */
  wandering: 39,
  /** 1: the pair comes near each other and was not in touch before. */
  meets: 42,
  /** Where it bounces: its normal speed before forces act, below 0, and how fast it is to let go, m/s. */
  approach: 43,
  back: 44,
  /** Speeds of surfaces that move and of what is carried, along the three directions, m/s. */
  driven: 45,
  size: 48,
} as const;

export const OPEN = 0;
export const STICKS = 1;
export const SLIDES = 2;

export class ConeContacts {
  count = 0;
  values = new Float64Array(C.size * 64);
  /** Numbers of both bodies; -1: it does not move. */
  a = new Int32Array(64);
  b = new Int32Array(64);
  /** On Bullet's heap. */
  pointers = new Int32Array(64);
  #kept = new Float64Array(0);

  /** Room for one more; returns where its numbers begin. */
  add(pointer: number, a: number, b: number): number {
    const i = this.count++;
    if (i === this.a.length) this.#grow();
    this.a[i] = a;
    this.b[i] = b;
    this.pointers[i] = pointer;
    return i * C.size;
  }

  /** Impulses as they are now, for `putBack`. */
  keep(contacts: readonly number[]): void {
    if (this.#kept.length < 3 * contacts.length) this.#kept = new Float64Array(6 * contacts.length);
    const c = this.values;
    for (let j = 0; j < contacts.length; j++)
      for (let k = 0; k < 3; k++) this.#kept[3 * j + k] = c[contacts[j]! * C.size + C.impulse + k]!;
  }

  putBack(contacts: readonly number[]): void {
    const c = this.values;
    for (let j = 0; j < contacts.length; j++)
      for (let k = 0; k < 3; k++) c[contacts[j]! * C.size + C.impulse + k] = this.#kept[3 * j + k]!;
  }

  /** Impulses are to begin at none. */
  forget(contacts: readonly number[]): void {
    const c = this.values;
    for (const i of contacts) c.fill(0, i * C.size + C.impulse, i * C.size + C.impulse + 3);
  }

  #grow(): void {
    const room = 2 * this.a.length;
    this.values = grown(this.values, C.size * room);
    this.a = grownInt(this.a, room);
    this.b = grownInt(this.b, room);
    this.pointers = grownInt(this.pointers, room);
  }
}

/** The speeds that velocities `v` (six numbers a body) give A against B along the three directions, at `out` of the contact. */
export function speeds(
  c: Float64Array,
  at: number,
  v: Float64Array,
  a: number,
  b: number,
  out: number,
): void {
  let x = 0;
  let y = 0;
  let z = 0;
  if (a >= 0) {
    const i = 6 * a;
    const rx = c[at + C.armA]!;
    const ry = c[at + C.armA + 1]!;
    const rz = c[at + C.armA + 2]!;
    const p = v[i + 3]!;
    const q = v[i + 4]!;
    const r = v[i + 5]!;
    x += v[i]! + q * rz - r * ry;
    y += v[i + 1]! + r * rx - p * rz;
    z += v[i + 2]! + p * ry - q * rx;
  }
  if (b >= 0) {
    const i = 6 * b;
    const rx = c[at + C.armB]!;
    const ry = c[at + C.armB + 1]!;
    const rz = c[at + C.armB + 2]!;
    const p = v[i + 3]!;
    const q = v[i + 4]!;
    const r = v[i + 5]!;
    x -= v[i]! + q * rz - r * ry;
    y -= v[i + 1]! + r * rx - p * rz;
    z -= v[i + 2]! + p * ry - q * rx;
  }
  c[at + out] = c[at]! * x + c[at + 1]! * y + c[at + 2]! * z;
  c[at + out + 1] = c[at + 3]! * x + c[at + 4]! * y + c[at + 5]! * z;
  c[at + out + 2] = c[at + 6]! * x + c[at + 7]! * y + c[at + 8]! * z;
}

/** Takes the push at `from` of the contact, times `s`, out of `g` (six numbers a body). */
export function takePush(
  c: Float64Array,
  at: number,
  g: Float64Array,
  a: number,
  b: number,
  from: number,
  s: number,
): void {
  const n = s * c[at + from]!;
  const t = s * c[at + from + 1]!;
  const u = s * c[at + from + 2]!;
  const x = n * c[at]! + t * c[at + 3]! + u * c[at + 6]!;
  const y = n * c[at + 1]! + t * c[at + 4]! + u * c[at + 7]!;
  const z = n * c[at + 2]! + t * c[at + 5]! + u * c[at + 8]!;
  if (a >= 0) takeWrench(g, 6 * a, c, at + C.armA, x, y, z);
  if (b >= 0) takeWrench(g, 6 * b, c, at + C.armB, -x, -y, -z);
}

function takeWrench(
  g: Float64Array,
  i: number,
  c: Float64Array,
  arm: number,
  x: number,
  y: number,
  z: number,
): void {
  const rx = c[arm]!;
  const ry = c[arm + 1]!;
  const rz = c[arm + 2]!;
  g[i]! -= x;
  g[i + 1]! -= y;
  g[i + 2]! -= z;
  g[i + 3]! -= ry * z - rz * y;
  g[i + 4]! -= rz * x - rx * z;
  g[i + 5]! -= rx * y - ry * x;
}

/**
 * What the contact pushes at speeds that miss by `miss`, or by `miss + s change`: the impulse so far less the penalty of
 * the miss, brought back into the friction cone.
 */
export function project(c: Float64Array, at: number, s: number): void {
  const penalty = c[at + C.penalty]!;
  const m = at + C.miss;
  const d = at + C.change;
  const n = c[at + C.impulse]! - penalty * (c[m]! + c[at + C.lift]! + s * c[d]!);
  const t = c[at + C.impulse + 1]! - penalty * (c[m + 1]! + s * c[d + 1]!);
  const u = c[at + C.impulse + 2]! - penalty * (c[m + 2]! + s * c[d + 2]!);
  const friction = c[at + C.friction]!;
  const along = Math.sqrt(t * t + u * u);
  const p = at + C.pushed;
  if (friction * along <= -n || (along === 0 && n <= 0)) {
    c[at + C.state] = OPEN;
    c[p] = c[p + 1] = c[p + 2] = 0;
  } else if (along <= friction * n) {
    c[at + C.state] = STICKS;
    c[p] = n;
    c[p + 1] = t;
    c[p + 2] = u;
  } else {
    const normal = (n + friction * along) / (1 + friction * friction);
    c[at + C.state] = SLIDES;
    c[at + C.along1] = along > 0 ? t / along : 1;
    c[at + C.along2] = along > 0 ? u / along : 0;
    c[at + C.turning] = along > 0 ? (friction * normal) / along : 0;
    c[p] = normal;
    c[p + 1] = friction * normal * c[at + C.along1]!;
    c[p + 2] = friction * normal * c[at + C.along2]!;
  }
}

/** Of `project`: how the push answers speeds, a symmetric 3 × 3 in world frame. False: it does not. */
export function stiffnessOf(c: Float64Array, at: number, w: Float64Array): boolean {
  const penalty = c[at + C.penalty]!;
  const state = c[at + C.state]!;
  if (state === OPEN) return false;
  const nx = c[at]!;
  const ny = c[at + 1]!;
  const nz = c[at + 2]!;
  const tx = c[at + 3]!;
  const ty = c[at + 4]!;
  const tz = c[at + 5]!;
  const ux = c[at + 6]!;
  const uy = c[at + 7]!;
  const uz = c[at + 8]!;
  if (state === STICKS) {
    setSquare(w, nx, ny, nz, penalty);
    addSquare(w, tx, ty, tz, penalty);
    addSquare(w, ux, uy, uz, penalty);
    return true;
  }
  const friction = c[at + C.friction]!;
  const t = c[at + C.along1]!;
  const u = c[at + C.along2]!;
  const p = friction * t;
  const q = friction * u;
  const share = penalty / (1 + friction * friction);
  setSquare(w, nx + p * tx + q * ux, ny + p * ty + q * uy, nz + p * tz + q * uz, share);
  const turning = penalty * c[at + C.turning]!;
  addSquare(w, t * ux - u * tx, t * uy - u * ty, t * uz - u * tz, turning);
  return true;
}

/** Of `project`, too: what comes through of a small change of what is wanted, in place at `change`. False: nothing. */
export function answerTo(c: Float64Array, at: number): boolean {
  const state = c[at + C.state]!;
  if (state !== SLIDES) return state === STICKS;
  const d = at + C.change;
  const friction = c[at + C.friction]!;
  const t = c[at + C.along1]!;
  const u = c[at + C.along2]!;
  const along = t * c[d + 1]! + u * c[d + 2]!;
  const aside = c[at + C.turning]! * (t * c[d + 2]! - u * c[d + 1]!);
  const normal = (c[d]! + friction * along) / (1 + friction * friction);
  c[d] = normal;
  c[d + 1] = friction * normal * t - aside * u;
  c[d + 2] = friction * normal * u + aside * t;
  return true;
}

/** w ← s d dᵀ */
function setSquare(w: Float64Array, x: number, y: number, z: number, s: number): void {
  const sx = s * x;
  const sy = s * y;
  w[0] = sx * x;
  w[4] = sy * y;
  w[8] = s * z * z;
  w[1] = w[3] = sx * y;
  w[2] = w[6] = sx * z;
  w[5] = w[7] = sy * z;
}

/** w ← w + s d dᵀ */
function addSquare(w: Float64Array, x: number, y: number, z: number, s: number): void {
  const sx = s * x;
  const sy = s * y;
  w[0]! += sx * x;
  w[4]! += sy * y;
  w[8]! += s * z * z;
  w[1] = w[3] = w[1]! + sx * y;
  w[2] = w[6] = w[2]! + sx * z;
  w[5] = w[7] = w[5]! + sy * z;
}
