// What was recorded of a scene, with its text: in an address where that is short, otherwise in a file.
import type { Run } from '../../physics-core/index.js';
import { deflated, inflated, LIMIT } from './packed.js';

/** Letters of a whole address. What passes addresses on is to take so many, and may take no more (RFC 9110, 4.1). */
export const LONGEST = 8000;

export interface Shared {
  markup: string;
  /** Of each world of the scene, in the order of the text, what its `exportRun()` gave. */
  runs: unknown[];
}

const TOO_LARGE = `This run is too large: the playground takes up to ${LIMIT / 1e6} MB.`;
const CUT_SHORT = 'This run can’t be read: it may have been cut short.';
const NO_RUN =
  'This is no run: a file that Share saves has the markup of a scene, and what was recorded.';

export const withRuns = async (hash: string, runs: unknown[]): Promise<string> =>
  `${hash}&run=${await deflated(JSON.stringify(runs))}`;

export async function runsIn(packed: string): Promise<unknown[]> {
  const runs = await parsed(() => inflated(packed));
  if (!areRuns(runs)) throw new Error(NO_RUN);
  return runs;
}

export function fileOf(shared: Shared): Blob {
  const file = new Blob([JSON.stringify(shared)], { type: 'application/json' });
  if (file.size > LIMIT) throw new Error(TOO_LARGE);
  return file;
}

export async function sharedIn(file: Blob): Promise<Shared> {
  if (file.size > LIMIT) throw new Error(TOO_LARGE);
  const given = (await parsed(() => file.text())) as Partial<Shared> | null;
  const { markup, runs } = given ?? {};
  if (typeof markup !== 'string' || !areRuns(runs)) throw new Error(NO_RUN);
  return { markup, runs };
}

/** Of any version; their worlds look closer. */
const areRuns = (runs: unknown): runs is unknown[] =>
  Array.isArray(runs) && runs.every((run: Partial<Run> | null) => run?.x3dPhysicsRun !== undefined);

async function parsed(text: () => Promise<string>): Promise<unknown> {
  try {
    return JSON.parse(await text());
  } catch (error) {
    throw new Error(error instanceof RangeError ? TOO_LARGE : CUT_SHORT);
  }
}

/** Asks for a file; nothing happens where none is chosen. */
export function chooseFile(chosen: (file: File) => void): void {
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', accept: '.json,application/json' });
  input.onchange = () => input.files?.[0] && chosen(input.files[0]);
  input.click();
}

/** Takes files of runs that are dropped on the playground; markup is dropped into the text, as everywhere. */
export function takeDropped(place: HTMLElement, dropped: (file: File) => void): void {
  place.addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  });
  const drop = (event: DragEvent): void => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file?.name.endsWith('.json')) return;
    event.preventDefault();
    event.stopPropagation();
    dropped(file);
  };
  // Before the text takes it for words.
  place.addEventListener('drop', drop, { capture: true });
}
