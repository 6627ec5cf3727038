import { Emitter, type Listener } from '../../base/emitter.js';
import { EventQueue } from '../../base/event-queue.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import { logProblem, ProblemLog, type Problem, type ProblemReport } from '../../base/problems.js';

/** Whether problems are logged, or what logs them. */
export type Console = boolean | ((problem: Problem) => void);

/** Problems and events: what a world tells those who run it. */
export class Reporting {
  readonly #problems = new ProblemLog();
  readonly #emitter = new Emitter();
  /** Its own events and those of its nodes, on their way to listeners. */
  readonly events = new EventQueue();

  constructor(log: Console) {
    const tell = log === true ? (problem: Problem) => logProblem(problem) : log;
    this.#problems.onreport = (problem, again) => {
      if (tell && !again) tell(problem);
      this.emit('problem', problem);
    };
  }

  get all(): Problem[] {
    return this.#problems.all;
  }

  report(report: ProblemReport, about: unknown): void {
    this.#problems.report(hostOf(about), report, about);
  }

  /** All is made anew: the console is not told again what it was told. */
  anew(make: () => void): void {
    this.#problems.anew(make);
  }

  settle(about: unknown, attribute?: string, code?: string): void {
    this.#problems.settle(hostOf(about), attribute, code);
  }

  /** What a node itself has reported of its host. */
  by(node: PhysicsNode): Problem[] {
    return this.#problems.by(node, node.host);
  }

  of(about: unknown): Problem[] {
    return this.#problems.of(hostOf(about));
  }

  on(event: string, listener: Listener): () => void {
    return this.#emitter.on(event, listener);
  }

  heard(event: string): boolean {
    return this.#emitter.heard(event);
  }

  emit(event: string, detail: unknown): void {
    this.events.tell(this.#emitter, event, detail);
  }
}

const hostOf = (about: unknown): unknown => (about instanceof PhysicsNode ? about.host : about);
