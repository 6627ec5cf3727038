import { tellPage } from '../document/misplaced.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { isPhysics, lowerName } from '../words/dom.js';
import { faultsFor, type Faults } from '../words/faults.js';
import { nodeOf } from '../x3dom/x3dom.js';

/** Of a name like these somebody expects physics. */
const OURS = /^(x3d-|(rigid|collid|contact|hinge|physics)|\w+-?joint$)/;

const CODE = 'unknown-tag';

/** Tags of which neither we nor anybody else makes something: they are told of, with the one that was meant. */
export class Strangers {
  readonly #worlds: { readonly all: Iterable<PageWorld> };
  readonly #met = new Set<Element>();
  readonly #told = new WeakSet<Element>();

  constructor(worlds: { readonly all: Iterable<PageWorld> }) {
    this.#worlds = worlds;
  }

  /** In a task of its own: others may define a custom element of that name, or x3dom a node. */
  add(element: Element): void {
    if (!OURS.test(lowerName(element)) || !isStranger(element)) return;
    if (this.#met.size === 0) setTimeout(() => this.#tell());
    this.#met.add(element);
  }

  /** It left the page. */
  delete(element: Element): void {
    this.#met.delete(element);
    if (!this.#told.delete(element)) return;
    for (const world of this.#worlds.all) world.settle(element, undefined, CODE);
  }

  #tell(): void {
    const [first] = this.#met;
    const faults = first && faultsFor(first, () => this.#tell());
    if (!faults) return;
    for (const element of this.#met) if (isStranger(element)) this.#tellOf(element, faults);
    this.#met.clear();
  }

  #tellOf(element: Element, faults: Faults): void {
    const report = faults.stranger(element);
    if (!report) return;
    this.#told.add(element);
    const [world] = this.#worlds.all;
    if (world) world.report(report, element);
    else tellPage(report, element);
  }
}

const isStranger = (element: Element): boolean =>
  !isPhysics(element) && !nodeOf(element) && !customElements.get(element.localName);
