import type {
  EffectReport,
  Problem,
  ProblemReport,
  RayHit,
  World,
} from '../../../physics-core/inside.js';
import type { Readers } from '../scopes/readers.js';
import type { Binding } from './binding.js';

// What nodes ask of where they stand; the rooms above have it.

/** What a ray hits in a page. */
export interface PageHit extends RayHit {
  element: Element;
}

/** How a world's bodies are drawn, where that is not x3dom's matter alone. */
export interface WorldDrawing {
  readonly stats: { batches: number; drawsSaved: number };
  readonly effects: EffectReport[];
  explain(body: Binding): string | undefined;
}

/** A world of the core, and who of the page lives in it. */
export interface PageWorld extends World {
  /** Its RigidBodyCollections, in the order of the document. */
  readonly collections: Set<Binding>;
  drawing?: WorldDrawing;
  /** In every frame, when bodies stand where they are drawn. */
  onshow?: () => void;
  /** The element beside the node: that of the body, or of the collidable without one. */
  raycast(...way: Parameters<World['raycast']>): PageHit | null;
  enter(member: Binding): void;
  leave(member: Binding): void;
}

/** The worlds of an `<x3d>`. */
export interface PageWorlds {
  /** For bodies outside any collection. */
  readonly default: PageWorld;
  of(collection: Binding): PageWorld;
  /** The world, where there is but one with bodies or a collection; asked again when that is another. */
  onlyFor(binding: Binding): PageWorld | undefined;
  isDefault(world: World | null): boolean;
  /** The collection that gives the default world its fields. */
  defaultCollection(): Binding | undefined;
}

/** The `<x3d>` in which a node stands. */
export interface Surroundings {
  /** Whether its nodes stand in the core; before that the document is still being read. */
  readonly live: boolean;
  readonly readers: Readers;
  readonly worlds: PageWorlds;
  /** Which body stands for which Transform. */
  readonly drivers: {
    of(transform: Element): Binding | undefined;
    rivalOf(binding: Binding): Binding | undefined;
  };
  /** Which body moves what on the screen. */
  readonly drawing: { bodyMoving(element: Element): Binding | undefined };
  readonly unlisted: { worldOf(collidable: Binding): PageWorld | undefined };
  readonly reports: {
    report(report: ProblemReport, binding: Binding): void;
    of(binding: Binding): Problem[];
    settle(binding: Binding, attributeName?: string, code?: string): void;
  };
  /** It has left, or stands elsewhere now. */
  drop(binding: Binding): void;
  /** What its node is to be may be another now. */
  dirty(binding: Binding): void;
  /** A collidable's own fields say another place. */
  placeChanged(collidable: Binding): void;
}
