import type { ProblemReport } from '../../../physics-core/inside.js';
import { tellPage } from '../document/misplaced.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { isPhysics, lowerName } from '../words/dom.js';
import { faultsFor, type Faults } from '../words/faults.js';
import { nodeOf } from '../x3dom/x3dom.js';
import { lateCode } from './late-tags.js';

/** Of a name like these somebody expects physics. */
const OURS = /^(x3d-|(rigid|collid|contact|hinge|physics)|\w+-?joint$)/;

type Say = (faults: Faults) => ProblemReport | undefined;

/** Elements that have a fault and are no nodes of ours: tags of which nobody makes something, first of all. */
export class Strangers {
  readonly #worlds: { readonly all: Iterable<PageWorld> };
  readonly #met = new Map<Element, Say>();
  readonly #told = new WeakSet<Element>();
  #due = false;

  constructor(worlds: { readonly all: Iterable<PageWorld> }) {
    this.#worlds = worlds;
  }

  add(element: Element): void {
    if (OURS.test(lowerName(element)) && isStranger(element) && !lateCode(element))
      this.note(element, (faults) => (isStranger(element) ? faults.stranger(element) : undefined));
  }

  note(element: Element, say: Say): void {
    this.#met.set(element, say);
  }

  /** It left the page. */
  delete(element: Element): void {
    this.#met.delete(element);
    if (this.#told.delete(element)) for (const world of this.#worlds.all) world.settle(element);
  }

  /** In a task of its own: others may define a custom element of that name, or x3dom a node. */
  tellSoon(): void {
    if (this.#due || this.#met.size === 0) return;
    this.#due = true;
    setTimeout(() => this.#tell());
  }

  #tell(): void {
    this.#due = false;
    const [first] = this.#met.keys();
    const faults = first && faultsFor(first, () => this.tellSoon());
    if (!faults) return;
    for (const [element, say] of this.#met) this.#tellOf(element, say(faults));
    this.#met.clear();
  }

  #tellOf(element: Element, report: ProblemReport | undefined): void {
    if (!report) return;
    this.#told.add(element);
    const [world] = this.#worlds.all;
    if (world) world.report(report, element);
    else tellPage(report, element);
  }
}

const isStranger = (element: Element): boolean =>
  !isPhysics(element) && !nodeOf(element) && !customElements.get(element.localName);
