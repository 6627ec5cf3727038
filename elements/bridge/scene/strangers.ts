import { advice, nodeTypes, show, type ProblemReport } from '../../../physics-core/inside.js';
import { tellPage } from '../document/misplaced.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { canAdvise } from '../words/attributes.js';
import { isPhysics, kebab, lowerName } from '../words/dom.js';
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
    if (this.#met.size === 0 || !canAdvise(() => this.#tell())) return;
    for (const element of this.#met) if (isStranger(element)) this.#tellOf(element);
    this.#met.clear();
  }

  #tellOf(element: Element): void {
    const report = reportOf(element);
    if (!report) return;
    this.#told.add(element);
    const [world] = this.#worlds.all;
    if (world) world.report(report, element);
    else tellPage(report, element);
  }
}

const isStranger = (element: Element): boolean =>
  !isPhysics(element) && !nodeOf(element) && !customElements.get(element.localName);

/** With the standard's name; a plain tag that resembles none of ours is not ours to speak of. */
function reportOf(element: Element): ProblemReport | undefined {
  const tag = element.localName;
  const found = advice.here ? advice.code.meantNode(tag, Object.keys(nodeTypes)) : undefined;
  const isOurs = tag.toLowerCase().startsWith('x3d-');
  if (!found && !isOurs) return undefined;
  const name = found?.type;
  const meant = name && `did you mean <${isOurs ? `x3d-${kebab(name)}` : name}>, X3D's ${name}?`;
  const text = [meant, found?.does].filter(Boolean).join(' ');
  return {
    code: CODE,
    severity: 'warning',
    value: tag,
    used: 'nothing',
    message: `<${show(tag)}> is no node${text ? `; ${text}` : ''}`,
  };
}
