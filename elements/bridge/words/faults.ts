import { advice, Chunk, type ProblemReport } from '../../../physics-core/inside.js';
import { logInPage } from './console.js';
import type { NodeType } from './dom.js';
import { loadFailed } from './load-failed.js';

/** An element as messages call it. */
export interface Labelled {
  element: Element;
  type: NodeType;
  label: string;
}

/** What is said of faults in the markup. */
export interface Faults {
  unknownAttribute(at: Labelled, name: string): ProblemReport;
  misplacedChild(at: Labelled, child: Element): ProblemReport;
  /** A child that x3dom would draw elsewhere. */
  undrawn(at: Labelled, child: Element): ProblemReport;
  otherTag(at: Labelled, child: Element, meant: Element): ProblemReport;
  duplicate(at: Labelled, def: string): ProblemReport;
  notUpgraded(): ProblemReport;
  /** A USE of what it stands in. */
  circle(use: Element): ProblemReport;
  /** A node that stands in itself. */
  nested(
    at: Labelled,
    found: { name?: string | undefined; label: string },
    role: string,
  ): ProblemReport;
  /** A node that lives in one place, and a second one that claims it. */
  owned(at: Labelled, owner: string | undefined, other: string, role: string): ProblemReport;
  /** Two bodies that stand for one element. */
  rival(at: Labelled, element: Element, rival: string, role: string): ProblemReport;
  /** A list of names. */
  namedCollidables(at: Labelled, text: string): ProblemReport;
  /** A collidable in a Transform that a body moves without it. */
  unmoved(at: Labelled, body: string): ProblemReport;
  /** A collidable or a space that nobody has. */
  unused(at: Labelled, isCollidable: boolean): ProblemReport;
  /** A field of a geometry. */
  malformed(geometry: Element, name: string, text: string): ProblemReport;
  /** x3dom's own engine ran before we came. */
  otherPhysics(): ProblemReport;
  /** A ROUTE from or to a field that there is not, or where X3D does not allow it. */
  refusedRoute(at: Labelled, name: string, verb: string): ProblemReport;
  /** The library is in the page a second time. */
  twoCopies(): ProblemReport;
  /** A node of ours that no scene will see. */
  outside(element: Element, inShadow: boolean): ProblemReport;
  /** A node of x3dom's that holds none, and one of ours in it. */
  swallowed(by: Element, element: Element): ProblemReport;
  /** What a world waited for too long. */
  late(waits: string): ProblemReport;
  /** A tag that nobody knows; undefined where it is none that we should know. */
  stranger(element: Element): ProblemReport | undefined;
  /** An Inline of whose file nothing came. */
  unread(inline: Element): ProblemReport;
  /** A geometry that collides and is not drawn. */
  notDrawn(geometry: Element): ProblemReport;
}

/** Pages whose markup has no fault don't fetch it. */
export const faults = new Chunk<Faults>({
  name: 'faults',
  causes: 'a fault in the markup',
}).comesFrom(() => import('./faults-code.js'));

let coming: Promise<unknown> | undefined;

/** What says it; undefined before that is here, and `again` is called then. */
export function faultsFor(element: Element, again: () => void): Faults | undefined {
  if (faults.here && advice.here) return faults.code;
  coming ??= Promise.all([faults.load(), advice.load()]).catch((error: unknown) =>
    logInPage({ ...missing(error), severity: 'warning' }, element),
  );
  void coming.then(() => faults.here && advice.here && again());
  return undefined;
}

const missing = (error: unknown): ProblemReport =>
  loadFailed('faults', 'the markup has a fault; the code that says which', error);
