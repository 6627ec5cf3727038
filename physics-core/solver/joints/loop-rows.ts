import { rowOf } from '../../base/cholesky.js';
import { SparseCholesky } from '../matrix/sparse-cholesky.js';
import { SparsePattern } from '../matrix/sparse-pattern.js';
import { addProducts, BODY_BLOCK, copy6, dot6, INERTIA, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import {
  backwardBody,
  backwardFree,
  factorBody,
  forwardBody,
  forwardFree,
} from './body-triangles.js';
import type { Component } from './forest.js';
import type { RowSystem } from './row-system.js';
import {
  FIRM_COMPLIANCE,
  LEAST_COMPLIANCE,
  LOOP_COMPLIANCE,
  MOST_PRODUCTS,
} from '../tolerances.js';

/** Two joints of a body, where their block lies, and from which sides they see the body. */
interface Coupling {
  /** In numbers of a block of rows. */
  a: number;
  b: number;
  first: number;
  second: number;
  at: number;
}

/** A component with loops: its matrix, and what of each body goes where in it. */
interface Loops {
  matrix: SparseCholesky;
  couplings: Coupling[];
  closing: Set<number>;
}

/**
 * All joints of a part with loops: the responses of their rows to impulses on all of them, J M⁻¹ Jᵀ, are a sparse matrix,
 * since only joints of the same body act on each other.
 */
export class LoopRows {
  readonly #system: RowSystem;
  /** Undefined: its joints are too many at one place. */
  readonly #known = new Map<Component, Loops | undefined>();
  /** Whose factors these are. */
  #component: Component | undefined;
  /** Cholesky factors of the inertia of bodies, and rows as they see them: L⁻¹ Jᵀ, as `jacobian`. */
  #bodies = new Float64Array(0);
  #seen = new Float64Array(0);
  /** Nothing but their inertia resists bodies. */
  #free = true;

  constructor(system: RowSystem) {
    this.#system = system;
  }

  forget(): void {
    this.#known.clear();
    this.#component = undefined;
  }

  growBodies(room: number): void {
    this.#bodies = new Float64Array(room * BODY_BLOCK);
  }

  growJoints(room: number): void {
    this.#seen = new Float64Array(room * 2 * ROW_BLOCK);
  }

  // ---- which joints act on each other -----------------------------------------------------------------------------------

  #loopsOf(component: Component): Loops | undefined {
    if (!this.#known.has(component)) this.#known.set(component, this.#look(component));
    return this.#known.get(component);
  }

  #look({ bodies, joints, loops }: Component): Loops | undefined {
    const { edges, rowCount } = this.#system;
    const numbers = new Map([...joints].map((joint, i) => [joint, i]));
    const meetings = new Map([...bodies].map((body) => [body, [] as number[]]));
    for (const joint of joints) {
      const { a, b } = edges[joint]!;
      meetings.get(a)?.push(joint);
      if (b !== a) meetings.get(b)?.push(joint);
    }
    let pairs = 0;
    for (const { length } of meetings.values()) pairs += (length * (length - 1)) / 2;
    if (pairs > MOST_PRODUCTS) return undefined;
    const neighbours = [...joints].map(() => new Set<number>());
    for (const meeting of meetings.values())
      for (const one of meeting)
        for (const other of meeting)
          if (one !== other) neighbours[numbers.get(one)!]!.add(numbers.get(other)!);
    const sizes = [...joints].map((joint) => rowCount[joint]!);
    const pattern = new SparsePattern(neighbours, MOST_PRODUCTS);
    if (pattern.tangled) return undefined;
    const matrix = new SparseCholesky(pattern, sizes);
    const couplings: Coupling[] = [];
    for (const [body, meeting] of meetings)
      meeting.forEach((one, i) => {
        for (const other of meeting.slice(0, i))
          couplings.push(this.#couple(body, one, other, numbers, matrix));
      });
    return { matrix, couplings, closing: new Set(loops) };
  }

  #couple(
    body: number,
    one: number,
    other: number,
    numbers: ReadonlyMap<number, number>,
    matrix: SparseCholesky,
  ): Coupling {
    const { block, straight } = matrix.pattern.between(numbers.get(one)!, numbers.get(other)!);
    const [a, b] = straight ? [one, other] : [other, one];
    const first = this.#side(a, body);
    const second = this.#side(b, body);
    return { a, b, first, second, at: matrix.block(block) };
  }

  /** Where the rows of a joint begin, as one of its bodies sees them. */
  #side(joint: number, body: number): number {
    return (joint * 2 + +(this.#system.edges[joint]!.a !== body)) * ROW_BLOCK;
  }

  // ---- factors ------------------------------------------------------------------------------------------------------

  /** False: singular, or too much. */
  factor(component: Component): boolean {
    const loops = this.#loopsOf(component);
    this.#component = loops && component;
    if (!loops) return false;
    this.#free = this.#system.resisting.size === 0;
    for (const body of component.bodies) if (!this.#factorBody(body)) return false;
    loops.matrix.numbers.fill(0);
    for (const joint of component.joints) this.#see(joint);
    this.#fill(component, loops);
    return loops.matrix.factor();
  }

  #factorBody(body: number): boolean {
    this.#system.writeInertia(body, this.#bodies, body * BODY_BLOCK);
    return factorBody(this.#bodies, body * BODY_BLOCK);
  }

  /** Rows that give way are left out. */
  #see(joint: number): void {
    const { edges, held, heldCount } = this.#system;
    const { a, b } = edges[joint]!;
    const at = joint * 2 * ROW_BLOCK;
    this.#seen.fill(0, at, at + 2 * ROW_BLOCK);
    for (let h = 0; h < heldCount[joint]!; h++) {
      const row = at + held[joint * ROWS + h]! * SIDE;
      if (a >= 0) this.#seeRow(a, row);
      if (b >= 0) this.#seeRow(b, row + ROW_BLOCK);
    }
  }

  #seeRow(body: number, row: number): void {
    copy6(this.#seen, row, this.#system.jacobian, row);
    const at = body * BODY_BLOCK;
    if (this.#free) forwardFree(this.#bodies, at, this.#seen, row);
    else forwardBody(this.#bodies, at, this.#seen, row);
  }

  #fill({ joints }: Component, { matrix, couplings, closing }: Loops): void {
    const { rowCount } = this.#system;
    const seen = this.#seen;
    const largest = this.#largest(closing);
    const give = this.#system.give * largest;
    const extra = Math.max(give, (this.#system.firm ? FIRM_COMPLIANCE : LOOP_COMPLIANCE) * largest);
    for (let i = 0; i < joints.length; i++) {
      const joint = joints[i]!;
      this.#fillDiagonal(
        joint,
        matrix.numbers,
        matrix.diagonal(i),
        closing.has(joint) ? extra : give,
      );
    }
    for (const { a, b, first, second, at } of couplings) {
      const end = first + rowCount[a]! * SIDE;
      const last = second + rowCount[b]! * SIDE;
      addProducts(matrix.numbers, at, seen, first, end, second, last);
    }
  }

  /** The largest response of a row that closes a loop. */
  #largest(closing: Iterable<number>): number {
    const { held, heldCount } = this.#system;
    let largest = 0;
    for (const joint of closing)
      for (let h = joint * ROWS; h < joint * ROWS + heldCount[joint]!; h++)
        largest = Math.max(largest, this.#alone(joint, held[h]!));
    return largest;
  }

  #fillDiagonal(joint: number, out: Float64Array, to: number, extra: number): void {
    const { rowCount } = this.#system;
    const seen = this.#seen;
    const at = joint * 2 * ROW_BLOCK;
    for (let r = 0; r < rowCount[joint]!; r++) {
      const row = at + r * SIDE;
      const into = to + rowOf(r);
      // What a row sees of no body is zero.
      for (let c = 0; c <= r; c++) {
        const column = at + c * SIDE;
        out[into + c] =
          dot6(seen, row, seen, column) + dot6(seen, row + ROW_BLOCK, seen, column + ROW_BLOCK);
      }
      out[into + r] = this.#softened(joint * ROWS + r, out[into + r]!, extra);
    }
  }

  /** A row that is left out stands for itself. */
  #softened(row: number, response: number, extra: number): number {
    if (!this.#system.holds(row)) return 1;
    return response * (1 + LEAST_COMPLIANCE) + this.#system.compliance[row]! + extra;
  }

  /** What an impulse on a row would do to it if no joint held its bodies, by the diagonals of their inertia. */
  #alone(joint: number, r: number): number {
    const { a, b } = this.#system.edges[joint]!;
    const at = joint * 2 * ROW_BLOCK + r * SIDE;
    return this.#aloneOn(a, at) + this.#aloneOn(b, at + ROW_BLOCK);
  }

  #aloneOn(body: number, at: number): number {
    if (body < 0) return 0;
    const { inertia, jacobian } = this.#system;
    let sum = 0;
    const from = body * INERTIA;
    for (let x = 0; x < 3; x++) {
      sum += jacobian[at + x]! ** 2 / inertia[from]!;
      sum += jacobian[at + 3 + x]! ** 2 / inertia[from + 1 + rowOf(x) + x]!;
    }
    return sum;
  }

  // ---- solving --------------------------------------------------------------------------------------------------------

  /** Velocities and impulses under `load`, which is used up. False: singular. */
  solve(component: Component, load: Float64Array): boolean {
    if (component !== this.#component && !this.factor(component)) return false;
    const { matrix } = this.#loopsOf(component)!;
    const { joints } = component;
    this.#move(component, load);
    matrix.vector.fill(0);
    for (let i = 0; i < joints.length; i++) this.#ask(joints[i]!, matrix.vector, matrix.at(i));
    matrix.solve();
    for (let i = 0; i < joints.length; i++)
      this.#push(joints[i]!, matrix.vector, matrix.at(i), load);
    this.#move(component, load);
    return true;
  }

  /** What the rows of a joint lack of the velocities that they are to have. */
  #ask(joint: number, vector: Float64Array, at: number): void {
    const { held, heldCount, targetVelocity } = this.#system;
    for (let h = joint * ROWS; h < joint * ROWS + heldCount[joint]!; h++) {
      const r = held[h]!;
      vector[at + r] = targetVelocity[joint * ROWS + r]! - this.#system.rate(joint, r);
    }
  }

  #push(joint: number, vector: Float64Array, at: number, load: Float64Array): void {
    const { held, heldCount, impulse } = this.#system;
    for (let h = joint * ROWS; h < joint * ROWS + heldCount[joint]!; h++) {
      const r = held[h]!;
      impulse[joint * ROWS + r] = vector[at + r]!;
      this.#system.push(joint, r, vector[at + r]!, load);
    }
  }

  /** Velocities as the load alone makes them. */
  #move({ bodies }: Component, load: Float64Array): void {
    const { velocity } = this.#system;
    for (const body of bodies) {
      const v = body * SIDE;
      copy6(velocity, v, load, v);
      const at = body * BODY_BLOCK;
      if (this.#free) {
        forwardFree(this.#bodies, at, velocity, v);
        backwardFree(this.#bodies, at, velocity, v);
      } else {
        forwardBody(this.#bodies, at, velocity, v);
        backwardBody(this.#bodies, at, velocity, v);
      }
    }
  }
}
