/** A joint's ends as numbers of bodies; -1 is the world or an immovable body. */
export interface Edge {
  a: number;
  b: number;
  /** Whether it holds points together, and whether it has rows besides. */
  pin?: boolean;
  rows?: boolean;
}

/** One connected part of the joint graph. */
export interface Component {
  /** From the leaves to the root. */
  bodies: Int32Array;
  /** All its joints; in a tree those that are pins; those that have rows; of these those that close loops. */
  joints: Int32Array;
  pins: Int32Array;
  rows: Int32Array;
  loops: Int32Array;
}

/**
 * Spanning trees of the joint graph: bodies eliminated from the leaves to the root fill in nothing. Joints that would
 * close a loop stand apart.
 */
export class Forest {
  /** By body: the joint to its parent, and the parent; -1 for none (a root, or held by the world). */
  jointOf = new Int32Array(0);
  parentOf = new Int32Array(0);
  /** By joint: the body that it joins to its parent; -1 for those that close loops. */
  childOf = new Int32Array(0);
  readonly components: Component[] = [];

  build(bodies: number, edges: readonly Edge[]): void {
    this.jointOf = new Int32Array(bodies).fill(-1);
    this.parentOf = new Int32Array(bodies).fill(-1);
    this.childOf = new Int32Array(edges.length).fill(-1);
    this.components.length = 0;
    const growth = new Growth(this, bodies, edges);
    // What the world holds first: its root is then at the world's end.
    edges.forEach(({ a, b }, edge) => {
      if (a < 0 || b < 0) growth.from(Math.max(a, b), edge);
    });
    // The others, those of no joint, too.
    for (let body = 0; body < bodies; body++) growth.from(body, -1);
  }
}

/** One run through the graph, breadth first. */
class Growth {
  readonly #forest: Forest;
  readonly #edges: readonly Edge[];
  readonly #edgesAt: number[][];
  readonly #seen: Uint8Array;
  readonly #used: Uint8Array;

  constructor(forest: Forest, bodies: number, edges: readonly Edge[]) {
    this.#forest = forest;
    this.#edges = edges;
    this.#edgesAt = Array.from({ length: bodies }, () => []);
    this.#seen = new Uint8Array(bodies);
    this.#used = new Uint8Array(edges.length);
    edges.forEach(({ a, b }, edge) => {
      if (a >= 0) this.#edgesAt[a]!.push(edge);
      if (b >= 0) this.#edgesAt[b]!.push(edge);
    });
  }

  /** The component of a body that no other holds yet. */
  from(root: number, joint: number): void {
    if (root < 0 || this.#seen[root]) return;
    const bodies: number[] = [];
    const joints: number[] = [];
    const loops: number[] = [];
    const visit = (body: number, through: number, parent: number): void => {
      this.#seen[body] = 1;
      this.#forest.jointOf[body] = through;
      this.#forest.parentOf[body] = parent;
      bodies.push(body);
      if (through < 0) return;
      this.#used[through] = 1;
      this.#forest.childOf[through] = body;
      joints.push(through);
    };
    visit(root, joint, -1);
    for (let i = 0; i < bodies.length; i++) {
      const body = bodies[i]!;
      for (const edge of this.#edgesAt[body]!) {
        if (this.#used[edge]) continue;
        const { a, b } = this.#edges[edge]!;
        const other = a === body ? b : a;
        if (other >= 0 && !this.#seen[other]) visit(other, edge, body);
        else {
          this.#used[edge] = 1;
          joints.push(edge);
          loops.push(edge);
        }
      }
    }
    // A loop that is closed more than once needs all its rows in one system (measured: a door on four hinges sticks).
    const pinned = (edge: number): boolean => loops.length === 0 && !!this.#edges[edge]!.pin;
    this.#forest.components.push({
      bodies: Int32Array.from(bodies.reverse()),
      joints: Int32Array.from(joints),
      pins: Int32Array.from(joints.filter(pinned)),
      rows: Int32Array.from(joints.filter((edge) => !pinned(edge) || this.#edges[edge]!.rows)),
      loops: Int32Array.from(loops),
    });
  }
}
