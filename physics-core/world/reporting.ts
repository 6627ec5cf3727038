import { Emitter, type Listener } from '../base/emitter.js';
import { EventQueue } from '../base/event-queue.js';
import { PhysicsNode } from '../nodes/node.js';
import { logProblem, ProblemLog, type Problem, type ProblemReport } from '../base/problems.js';

/** Whether problems are logged, or what logs them. */
export type Console = boolean | ((problem: Problem) => void);

/** Problems and events: what a world tells those who run it. */
export abstract class Reporting {
  readonly #problems = new ProblemLog();
  readonly #emitter = new Emitter();
  /** Its own events and those of its nodes, on their way to listeners. */
  readonly events = new EventQueue();

  constructor(log: Console) {
    const tell = log === true ? (problem: Problem) => logProblem(problem) : log;
    this.#problems.onreport = (problem) => {
      if (tell) tell(problem);
      this.emit('problem', problem);
    };
  }

  get problems(): Problem[] {
    return this.#problems.all;
  }

  report(report: ProblemReport, about: PhysicsNode | unknown = this): void {
    this.#problems.report(hostOf(about), report, about);
  }

  settle(about: PhysicsNode | unknown, attribute?: string, code?: string): void {
    this.#problems.settle(hostOf(about), attribute, code);
  }

  /** A node is gone, and with it what it reported; what others say of its element stands. */
  takeBack(node: PhysicsNode): void {
    for (const { attribute, code } of this.#problems.by(node, node.host))
      this.settle(node.host, attribute, code);
  }

  problemsOf(about: PhysicsNode | unknown): Problem[] {
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
