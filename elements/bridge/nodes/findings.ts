import { show, type ProblemReport } from '../../../physics-core/inside.js';
import { setState } from '../base/states.js';
import { nameOf, type NodeType } from '../words/dom.js';
import { faultsFor, type Faults } from '../words/faults.js';

/** What is wrong with an element, and what it waits for: told once its node is as its surroundings say. */
export abstract class Findings {
  readonly element: Element;
  readonly type: NodeType;
  /** ROUTEs that may not be: `from` or `to` a field. */
  readonly #refused = new Map<string, string>();
  #waiting = new Map<string, string>();
  /** What was reported while its node was planned: taken back when the next plan does not find it again. */
  #found = new Map<string, ProblemReport>();
  #told = this.#found;
  #planning = false;

  /** Takes a report to those who hear of it. */
  protected abstract tell(report: ProblemReport): void;
  /** Takes a report back. */
  abstract settle(code: string, attributeName?: string): void;
  abstract dirty(): void;

  constructor(element: Element, type: NodeType) {
    this.element = element;
    this.type = type;
  }

  get name(): string | undefined {
    return nameOf(this.element);
  }

  get label(): string {
    return this.name ? `${this.type.name} "${this.name}"` : this.type.name;
  }

  problem(report: ProblemReport): void {
    if (this.#planning) this.#found.set(`${report.code} ${report.attribute}`, report);
    else this.tell(report);
  }

  /** The same, in words that only those fetch who have a fault in their markup. */
  fault(say: (faults: Faults) => ProblemReport): void {
    const faults = faultsFor(this.element, () => this.dirty());
    if (faults) this.problem(say(faults));
  }

  /** A ROUTE that may not be: told with what its markup has wrong. */
  refuse(name: string, verb: string): void {
    this.#refused.set(name, verb);
    this.dirty();
  }

  /** That ROUTE went. */
  permit(name: string): void {
    if (this.#refused.delete(name)) this.dirty();
  }

  get refused(): Iterable<[name: string, verb: string]> {
    return this.#refused;
  }

  /** A name that nobody bears yet. */
  waitFor(role: string, name: string): void {
    this.#waiting.set(role, name);
    const what = role === 'for' ? `"${show(name)}"` : `${role} "${show(name)}"`;
    this.problem({
      code: 'unknown-reference',
      severity: 'warning',
      attribute: role,
      value: name,
      used: 'nothing',
      message: `${this.label} waits for ${what}, which is not there`,
    });
  }

  /** What it waits for, by role. */
  get waiting(): ReadonlyMap<string, string> {
    return this.#waiting;
  }

  beginPlan(): void {
    this.#waiting = new Map();
    this.#told = this.#found;
    this.#found = new Map();
  }

  /** Reads what its node is to be; what that finds wrong is told by `tellFound`. */
  plan<T>(read: () => T): T {
    this.#planning = true;
    try {
      return read();
    } finally {
      this.#planning = false;
    }
  }

  /** Reports what the plan found and takes back what it no longer found, once its node is as planned. */
  tellFound(): void {
    for (const report of this.#found.values()) this.problem(report);
    for (const [key, { code, attribute: name }] of this.#told)
      if (!this.#found.has(key)) this.settle(code, name);
    this.#told = this.#found;
    setState(this.element, 'waiting', this.#waiting.size > 0);
  }

  /** Whether the markup as last read has this problem, whatever its node says of the field. */
  found(code: string, attributeName: string | undefined): boolean {
    return this.#found.has(`${code} ${attributeName}`);
  }
}
