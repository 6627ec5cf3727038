import type { X3DUIElement } from './ui-element.js';

/** What an element of the ui shows: made when the first such element is in a page, from a chunk of its own. */
export interface View {
  /** In the page and in sight: from now on it is kept up to date. */
  start(): void;
  /** Gone from the page or out of sight: it costs nothing until the next start. */
  stop(): void;
  /** An attribute or property changed. */
  changed(): void;
}

/** One file `elements/ui/<name>/view.ts`. */
export interface ViewModule {
  createView(host: X3DUIElement): View;
  /** What was fetched for it, bytes as a server sends them (gzip): the build says so. */
  readonly bytes?: number;
}

/** Where the classic scripts have their views: beside themselves, since they are one file each. */
let folder: string | undefined;

export function setViewFolder(address: string): void {
  folder = address;
}

/** `own`: the import that the module build makes a chunk of. */
export function loadView(name: string, own: () => Promise<ViewModule>): Promise<ViewModule> {
  if (folder === undefined) return own();
  return import(new URL(`ui/${name}.js`, folder).href) as Promise<ViewModule>;
}
