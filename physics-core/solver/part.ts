import { grownInt } from '../base/grown.js';

/** Bodies that hang together by contacts and joints, and what holds them: numbers of a step's bodies, contacts and rows. */
export interface Part {
  readonly bodies: number[];
  /** Pointers of Bullet's manifolds. */
  readonly manifolds: number[];
  readonly contacts: number[];
  /** Of joints, or what keeps bodies of a heap from rolling. */
  readonly rows: number[];
  /** It is solved here, not by Bullet. */
  direct: boolean;
  jointed: boolean;
  /** Bodies of it hang on joints, which may close loops: a net, a bridge on two ropes. */
  hangs: boolean;
  looped: boolean;
  /** Rows of its joints were laid where the step ends. */
  curved: boolean;
  /** It begins with what its weight asks for. */
  stands: boolean;
  /** It is near so many others that they make a heap. */
  inHeap: boolean;
  /** Its level is content with less than what is exact in it. */
  rough: boolean;
}

/** The parts of a step. Their arrays are kept from step to step. */
export class Parts {
  readonly #pool: Part[] = [];
  #count = 0;
  #parents = new Int32Array(16);
  #partOf = new Int32Array(16);
  readonly #hanging = new Set<number>();
  readonly #looped = new Set<number>();

  begin(): void {
    this.#count = 0;
    this.#hanging.clear();
    this.#looped.clear();
  }

  /** One more body, which hangs together with nobody so far. */
  add(body: number): void {
    if (body >= this.#parents.length) {
      this.#parents = grownInt(this.#parents, 2 * body);
      this.#partOf = new Int32Array(2 * body);
    }
    this.#parents[body] = body;
  }

  #root(body: number): number {
    const parents = this.#parents;
    while (parents[body]! !== body) body = parents[body] = parents[parents[body]!]!;
    return body;
  }

  join(a: number, b: number): void {
    this.#parents[this.#root(a)] = this.#root(b);
  }

  /** It hangs on joints. */
  hangs(body: number): void {
    this.#hanging.add(body);
  }

  /** These close loops. */
  loops(body: number): void {
    this.#looped.add(body);
  }

  /** All are joined: each body goes to its part. */
  sort(bodies: number): void {
    this.#partOf.fill(-1, 0, bodies);
    for (let i = 0; i < bodies; i++) {
      const root = this.#root(i);
      if (this.#partOf[root]! < 0) this.#partOf[root] = this.#begin();
      const part = this.#partOf[root]!;
      this.#pool[part]!.bodies.push(i);
    }
    for (const body of this.#hanging) this.of(body).hangs = true;
    for (const body of this.#looped) this.of(body).looped = true;
  }

  #begin(): number {
    const part = (this.#pool[this.#count] ??= {
      bodies: [],
      manifolds: [],
      contacts: [],
      rows: [],
      direct: false,
      jointed: false,
      hangs: false,
      looped: false,
      curved: false,
      stands: false,
      inHeap: false,
      rough: false,
    });
    part.hangs = part.looped = part.curved = part.stands = false;
    part.bodies.length = part.manifolds.length = part.contacts.length = part.rows.length = 0;
    return this.#count++;
  }

  of(body: number): Part {
    return this.#pool[this.#partOf[this.#root(body)]!]!;
  }

  get count(): number {
    return this.#count;
  }

  at(i: number): Part {
    return this.#pool[i]!;
  }
}
