import type { Chunk } from '../../base/chunk.js';
import type { ProblemReport } from '../../base/problems.js';
import { contacts } from '../../effects/effect/chunks.js';
import { BodyNode } from '../../nodes/body/body.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { chunks } from '../chunks/all.js';

/** Code that could not be had is tried again after this long, milliseconds. */
const AGAIN = 5000;

function chunksHere(): number {
  let here = 0;
  for (const chunk of chunks) if (chunk.here) here++;
  return here;
}

/** A node, and the code that is not here yet but it can't be made without. */
interface Missing {
  node: PhysicsNode;
  chunk: Chunk<unknown>;
}

/** The world that waits. */
interface WaitingWorld extends NodeWorld {
  codeCame(): void;
}

/** A world that starts once code is here. */
export interface Starting {
  start(): void;
  failed(problem: ProblemReport): void;
}

/**
 * Waits for code of effects that nodes call for: what they were written with acts when all of it can. Time stands still
 * meanwhile, so that a scene moves in the same way however long that takes.
 */
export class Awaiting {
  readonly #world: WaitingWorld;
  #waits = false;
  /** How many chunks were here when it looked last. */
  #seen = 0;

  constructor(world: WaitingWorld) {
    this.#world = world;
  }

  /** A Bullet world was made: all that comes into it meets the code that is here. */
  begin(): void {
    this.#seen = chunksHere();
    this.#world.codeCame();
    for (const node of this.#world.nodes) node.codeCame();
  }

  get waits(): boolean {
    return this.#waits;
  }

  /** Whether nodes that are to be made or patched need code that is not here: then it is fetched. */
  holds(nodes: Iterable<PhysicsNode>, starting?: Starting): boolean {
    if (this.#world.started && this.#seen !== chunksHere()) this.#look();
    if (this.#waits || chunksHere() === chunks.length) return this.#waits;
    const missing = [...this.#missing(nodes)];
    if (missing.length === 0) return false;
    this.#waits = true;
    void this.#fetch(missing, starting);
    return true;
  }

  /** Time stands still until that is here, and it is done. */
  async stand(code: Promise<void>, then: () => void): Promise<void> {
    this.#waits = true;
    await code.catch(() => {});
    this.#waits = false;
    then();
    this.#world.work();
  }

  *#missing(nodes: Iterable<PhysicsNode>): Generator<Missing> {
    for (const node of nodes) {
      for (const chunk of node.needs) if (!chunk.here) yield { node, chunk };
      if (!contacts.here && node instanceof BodyNode && !this.#isAlone(node))
        yield { node, chunk: contacts };
    }
  }

  /** The only body of its world: there is nothing that it could touch. */
  #isAlone(body: BodyNode): boolean {
    for (const node of this.#world.nodes)
      if (node instanceof BodyNode && node !== body) return false;
    return true;
  }

  async #fetch(missing: readonly Missing[], starting: Starting | undefined): Promise<void> {
    if (this.#world.started) this.#tell(missing);
    try {
      await Promise.all(missing.map(({ chunk }) => chunk.load()));
    } catch (error) {
      const problem = this.#fail(missing, error);
      starting?.failed(problem);
      await new Promise((resolve) => setTimeout(resolve, AGAIN));
    }
    this.#over(missing);
    starting?.start();
    this.#world.work();
  }

  /** Code has come, to this world or another: what was made before may cause effects, too. */
  #look(): void {
    this.#seen = chunksHere();
    this.#world.codeCame();
    for (const node of this.#world.nodes) {
      node.codeCame();
      if (node instanceof BodyNode && node.built) this.#world.registry.codeCame(node);
    }
    // The one setting that contacts alone heed.
    if (this.#world.settings.asked<number>('maxCorrectionSpeed') >= 0) this.#world.configure();
  }

  #over(missing: readonly Missing[]): void {
    this.#waits = false;
    if (missing.some(({ chunk }) => !chunk.here)) return;
    for (const code of ['waiting-for-effect', 'effect-load-failed'])
      for (const { node } of missing) node.settle(undefined, code);
  }

  #tell([first]: readonly Missing[]): void {
    const { node, chunk } = first!;
    node.report({
      code: 'waiting-for-effect',
      severity: 'info',
      value: chunk.name,
      message: `time stands still until the code of "${chunk.name}" is here, which ${node.label} needs`,
    });
  }

  #fail([first]: readonly Missing[], error: unknown): ProblemReport {
    const { node, chunk } = first!;
    const problem: ProblemReport = {
      code: 'effect-load-failed',
      severity: 'error',
      value: chunk.name,
      used: 'another attempt',
      message: `the code of "${chunk.name}", which ${node.label} needs, could not be loaded: ${String(error)}; until it is, time stands still`,
    };
    node.report(problem);
    return problem;
  }
}
