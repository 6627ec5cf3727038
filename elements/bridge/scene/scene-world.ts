import {
  World,
  type PhysicsNode,
  type Problem,
  type RayHit,
  type Run,
} from '../../../physics-core/inside.js';
import { setState } from '../base/states.js';
import { loop } from '../drawing/loop.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import type { PageHit, PageWorld, WorldDrawing } from '../nodes/surroundings.js';
import type { Scopes } from '../scopes/scopes.js';
import { explanation, type Known } from '../outward/explain.js';
import { logInPage } from '../words/console.js';

/** The longest stretch a world takes at once without calling it lag, seconds. */
const STRETCH = 0.1;

/** A world whose nodes stand in an `<x3d>`. */
export class SceneWorld extends World implements PageWorld {
  readonly #scopes: Scopes;
  /** All that live in it, with a node or without one yet. */
  readonly #members = new Set<Binding>();
  /** Those of them that make a world; the others go where those are. */
  #founders = 0;
  readonly collections = new Set<Binding>();
  /** Something came since the last frame that the next one is to look at. */
  #work = true;
  /** It took no part in the last frame: what time passed before the next one is not its own. */
  #stood = true;
  /** Edits of plain tags are seen by an observer that has not run yet: has it run now. */
  onflush?: () => void;

  constructor(scopes: Scopes) {
    super({ console: (problem) => logInPage(problem, problem.element) });
    this.#scopes = scopes;
    this.onwork = () => {
      this.#work = true;
      loop.wake();
    };
  }

  drawing?: WorldDrawing;
  onshow?: () => void;

  override flush(): void {
    this.onflush?.();
    super.flush();
  }

  /** A paused world is drawn after a step by hand, too. */
  override step(n = 1): number {
    const seconds = super.step(n);
    this.work();
    return seconds;
  }

  /** A field with a value that the core can use may still have a problem in the markup: that stands. */
  override settle(about: unknown, attributeName?: string, code?: string): void {
    const element = about instanceof Element ? about : (about as { host?: unknown }).host;
    if (!(element instanceof Element)) {
      super.settle(about, attributeName, code);
      for (const collection of this.collections) this.#showProblems(collection.element);
      return;
    }
    for (const problem of this.problemsOf(element)) {
      if (attributeName && problem.attribute !== attributeName) continue;
      if (!code && ownBinding(element)?.found(problem.code, problem.attribute)) continue;
      if (!code || problem.code === code) super.settle(element, problem.attribute, problem.code);
    }
    this.#showProblems(element);
  }

  /** A collection shows those of the world itself, too. */
  #showProblems(element: Element): void {
    const binding = ownBinding(element);
    const own = this.problemsOf(element).length > 0;
    const worlds = !!binding && this.collections.has(binding) && this.problemsOf(this).length > 0;
    setState(element, 'problem', own || worlds);
  }

  /** The element beside the node: that of the body, or of the collidable without one. */
  override raycast(...way: Parameters<World['raycast']>): PageHit | null {
    const hit = super.raycast(...way);
    return hit && { ...hit, element: hit.node.host as Element };
  }

  /** Of elements `explain` tells all that the function of that name tells. */
  override async ask(method: string, ...args: unknown[]): Promise<unknown> {
    const answer = await super.ask(method, ...args);
    if (method === 'raycast' && answer)
      return { ...answer, element: (answer as RayHit).node.host as Element };
    const [element] = args;
    if (method !== 'explain' || !(element instanceof Element)) return answer;
    const meant = this.#scopes.meant(element);
    return explanation(element, meant && ownBinding(meant), answer as Known);
  }

  /** By name, or by an element, also one that only stands for another by USE. */
  override node(nameOrElement: unknown): PhysicsNode | undefined {
    if (typeof nameOrElement === 'string')
      return this.#named(nameOrElement) ?? super.node(nameOrElement);
    const element =
      nameOrElement instanceof Element ? this.#scopes.meant(nameOrElement) : nameOrElement;
    if (element instanceof Element) return this.#nodeOf(element);
    return element == null ? undefined : super.node(element);
  }

  /** Asked of its host, the core might answer with the collidable that a shortcut gives a body. */
  #nodeOf(element: Element): PhysicsNode | undefined {
    const binding = ownBinding(element);
    return binding?.world === this ? (binding.node ?? undefined) : undefined;
  }

  /** Its node has one name only, an element may have a DEF and an id. */
  #named(name: string): PhysicsNode | undefined {
    for (const scope of this.#scopes) {
      const element = scope.find(name);
      const node = element && this.#nodeOf(element);
      if (node) return node;
    }
    return undefined;
  }

  /** With the scene that it happened in. */
  override exportRun(): Run | undefined {
    const run = super.exportRun();
    if (run) run.markup = this.#scopes.x3d.querySelector('scene, Scene')?.outerHTML;
    return run;
  }

  // ---- frames -----------------------------------------------------------------------------------------------------

  /** Nothing in it is awake or has changed: a frame would do nothing. */
  get atRest(): boolean {
    return !this.#work && !this.stepping.needsFrame;
  }

  /** A frame passes it by. */
  stand(): void {
    this.#stood = true;
  }

  /** Time passes, in seconds; a hidden page gets a frame per second, which is taken in pieces. */
  pass(seconds: number, hidden: boolean): boolean {
    let left = this.#stood ? 0 : seconds;
    this.#work = this.#stood = false;
    for (; hidden && left > STRETCH; left -= STRETCH) this.frame(STRETCH, false);
    return this.frame(left, !hidden);
  }

  // ---- who lives in it --------------------------------------------------------------------------------------------

  enter(member: Binding): void {
    this.#members.add(member);
    if (isFounder(member)) this.#founders++;
  }

  leave(member: Binding): void {
    this.#members.delete(member);
    if (isFounder(member)) this.#founders--;
  }

  /** Whether it has a body or a collection. */
  get founded(): boolean {
    return this.#founders > 0;
  }

  /** Whether nothing lives in it any more, what script added included. */
  get deserted(): boolean {
    const [node] = this.nodes;
    return this.#members.size === 0 && !node;
  }

  /** For good; what it holds of Bullet is given back. `gone`: what left the page. */
  end(gone: string): void {
    if (!this.started) this.lifecycle.ready.reject(this.#over(gone));
    this.destroy();
  }

  #over(gone: string): Problem {
    return {
      code: 'world-ended',
      severity: 'info',
      value: gone,
      message: `the world ended before it had started: ${gone} left the page`,
      element: this.#scopes.x3d,
    };
  }

  /** Keeps running while the page is hidden or the scene scrolled away. */
  get runsHidden(): boolean {
    for (const collection of this.collections) if (collection.get('runHidden')) return true;
    return false;
  }
}

const isFounder = (member: Binding): boolean => member.is('RigidBodyCollection', 'RigidBody');
