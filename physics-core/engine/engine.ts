import { fetchGlue, loadAmmo, type Ammo } from './ammo.js';
import { HeapExhausted } from './exhausted.js';
import { BodyReader } from './heap.js';
import type { PairTest } from './pair-test.js';
import { Scratch } from './scratch.js';
import { SolverHook } from './solver-hook.js';
import { StepStages } from './step-stages.js';
import { VelocityWriter } from './velocity-writer.js';
import type { Sweep } from './sweep.js';
import { compileAmmo, type LoadOptions } from './wasm.js';

/** A heap that has not even this many bytes left is full. */
const BLOCK = 65536;

/** Ammo and what all worlds share of it: argument objects and the way state is read. */
export class Engine {
  readonly ammo: Ammo;
  /** What it was made of, for others like it. In Node running from source there is no `program`. */
  readonly source: LoadOptions;
  readonly scratch: Scratch;
  readonly reader: BodyReader;
  readonly velocities: VelocityWriter;
  readonly solverHook: SolverHook;
  readonly stages: StepStages;
  /** Made by those who ask first: `pairTestOf`, `sweepOf`. */
  pairTest: PairTest | undefined;
  sweep: Sweep | undefined;

  constructor(ammo: Ammo, source: LoadOptions = {}) {
    this.ammo = ammo;
    this.source = source;
    this.scratch = new Scratch(ammo);
    this.solverHook = new SolverHook(ammo);
    this.stages = new StepStages(ammo);
    this.reader = new BodyReader(ammo);
    this.velocities = new VelocityWriter(ammo);
  }

  /** A step begins: points that were found after the last one are of the past. */
  forgetFound(world: Parameters<PairTest['clear']>[0]): void {
    this.pairTest?.clear(world);
  }

  /** One more of the same wasm, with a heap of its own. */
  another(): Promise<Engine> {
    return makeEngine(this.source);
  }

  /** Whether that is why Ammo gave up: what runs out of room may also stop as a trap of the wasm. */
  isExhaustion(error: unknown): boolean {
    if (error instanceof HeapExhausted) return true;
    // A block that is given is never returned, but traps are rare.
    return error instanceof WebAssembly.RuntimeError && this.ammo._malloc(BLOCK) === 0;
  }

  /** Bytes of the wasm heap, shared by all worlds of the page. It never shrinks. */
  get heapBytes(): number {
    return this.ammo.HEAPU8.length;
  }
}

async function makeEngine(options: LoadOptions): Promise<Engine> {
  // Both come at the same time; that the wasm can't be had is told first.
  const glue = fetchGlue();
  glue.catch(() => {});
  const source = await compileAmmo(options);
  return new Engine(await loadAmmo(await glue, source.program), source);
}

let loading: Promise<Engine> | undefined;

/** One engine per page, worker or process. A failed load may be tried again. */
export function loadEngine(options: LoadOptions = {}): Promise<Engine> {
  if (loading) return loading;
  loading = makeEngine(options);
  // Once, and before anybody else hears of it: who then tries again is not to lose that load.
  loading.catch(() => (loading = undefined));
  return loading;
}
