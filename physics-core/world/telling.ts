import { Emitter, type Listener } from '../emitter.js';
import { EventQueue } from '../event-queue.js';
import { PhysicsNode } from '../nodes/node.js';
import { ProblemLog, type Problem, type ProblemReport } from '../problems.js';

/** Problems and events: what a world tells those who run it. */
export abstract class Telling {
  readonly #problems: ProblemLog;
  readonly #emitter = new Emitter();
  /** Its own events and those of its nodes, on their way to listeners. */
  readonly events = new EventQueue();

  constructor(logToConsole: boolean) {
    this.#problems = new ProblemLog(logToConsole);
    this.#problems.onreport = (problem) => this.emit('problem', problem);
  }

  get problems(): Problem[] {
    return this.#problems.all;
  }

  report(report: ProblemReport, about?: PhysicsNode | unknown): void {
    this.#problems.report(about instanceof PhysicsNode ? about.host : (about ?? this), report);
  }

  settle(about: PhysicsNode | unknown, attribute?: string, code?: string): void {
    this.#problems.settle(about instanceof PhysicsNode ? about.host : about, attribute, code);
  }

  problemsOf(about: PhysicsNode | unknown): Problem[] {
    return this.#problems.of(about instanceof PhysicsNode ? about.host : about);
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
