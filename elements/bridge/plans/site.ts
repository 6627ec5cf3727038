import type { Drivers } from '../document/drivers.js';
import type { Unlisted } from '../document/unlisted.js';
import type { Drawing } from '../drawing/drawing.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld, PageWorlds, Surroundings } from '../nodes/surroundings.js';
import type { Scopes } from '../scopes/scopes.js';

/** The `<x3d>` whose nodes are brought up to date, and what hears of that. */
export interface Site extends Surroundings {
  readonly scopes: Scopes;
  readonly drawing: Drawing;
  readonly drivers: Drivers;
  readonly unlisted: Unlisted;
  readonly worlds: PageWorlds & {
    /** Bodies or collections came or went: those that live in the only world are asked anew. */
    checkOnly(): void;
    /** It has left. */
    forget(binding: Binding): void;
  };
  /** Elements that were inserted. */
  readonly arrivals: { readonly size: number; take(): void; clear(): void };
  /** Everything seen so far is to be brought to the core. */
  settle(): void;
  /** A node was made, changed its place, or went. */
  nodeChanged(binding: Binding): void;
  /** A world has other collections than before. */
  collectionsChanged(world: PageWorld): void;
  /** The core is as the document says. */
  updated(): void;
}
