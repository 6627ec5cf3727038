import type { Problem, ProblemReport } from '../../../physics-core/inside.js';
import { tellPage } from '../document/misplaced.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';

/** Takes what authors get wrong to the world that hears of it. */
export class Reports {
  readonly #worlds: { readonly all: Iterable<PageWorld> };
  /** Called when a report waits for a world that hears of it. */
  readonly #onunheard: () => void;
  readonly #unheard: { report: ProblemReport; binding: Binding }[] = [];

  constructor(worlds: { readonly all: Iterable<PageWorld> }, onunheard: () => void) {
    this.#worlds = worlds;
    this.#onunheard = onunheard;
  }

  /** Of a node that lives in no world, the first world hears; a report makes no world. */
  report(report: ProblemReport, binding: Binding): void {
    const [first] = this.#worlds.all;
    const world = binding.world ?? first;
    if (world) return world.report(report, binding.element);
    this.#unheard.push({ report, binding });
    this.#onunheard();
  }

  /** Where there still is no world, the console and the page hear. */
  tellUnheard(): void {
    const [first] = this.#worlds.all;
    for (const { report, binding } of this.#unheard.splice(0)) {
      if (first) this.report(report, binding);
      else if (binding.scope) tellPage(report, binding.element);
    }
  }

  /** What is told of it: that of a node without a world stands in another's. */
  of({ element }: Binding): Problem[] {
    return [...this.#worlds.all].flatMap((world) => world.problemsOf(element));
  }

  settle(binding: Binding, attributeName?: string, code?: string): void {
    for (const world of this.#worlds.all) world.settle(binding.element, attributeName, code);
  }
}
