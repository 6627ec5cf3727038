import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import type { Setting } from '../engines/engine.js';
import { MACHINE } from './machine.js';
import type { Row } from './row.js';
import { sourcesOf } from './sources.js';

// Rows measured so far: a run of the lab that was broken off goes on where it was.

const FOLDER = new URL('../../node_modules/.cache/x3d-physics-lab/', import.meta.url);

type Stored = Record<string, Row>;

const fileOf = (id: string): URL => new URL(`${id}.json`, FOLDER);

/** Of one run: change what it hangs on, and it is another. */
const keyOf = (engine: string, { level = '', step, iterations }: Setting): string =>
  [engine, level, step, iterations, sourcesOf(engine), MACHINE].join(' ');

export class Store {
  readonly #case: string;
  readonly #rows: Stored;

  /** `fresh`: as if nothing had been measured. */
  constructor(id: string, fresh: boolean) {
    this.#case = id;
    this.#rows = fresh ? {} : read(id);
  }

  get(engine: string, setting: Setting): Row | undefined {
    return this.#rows[keyOf(engine, setting)];
  }

  set(engine: string, setting: Setting, row: Row): void {
    this.#rows[keyOf(engine, setting)] = row;
  }

  save(): void {
    mkdirSync(FOLDER, { recursive: true });
    writeFileSync(fileOf(this.#case), JSON.stringify(this.#rows));
  }
}

function read(id: string): Stored {
  try {
    return JSON.parse(readFileSync(fileOf(id), 'utf8')) as Stored;
  } catch {
    return {};
  }
}
