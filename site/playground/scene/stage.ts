// The scene beside the text: it begins anew from a text, or is brought to one while it runs.
import { clean, type LeftOut } from '../text/left-out.js';
import type { ElementNode, TreeNode } from '../text/tree.js';
import { whole } from '../text/whole.js';
import { openScenePage, type ScenePage, type World } from './frame.js';
import { LiveTree } from './live.js';
import { x3domDefault, x3domTags } from './x3dom-nodes.js';

type Problem = World['problems'][number];

export interface Told {
  problem: Problem;
  /** What the text has of it. */
  source: ElementNode | undefined;
}

/** What leads to every world: its collections, and what may stand outside any. */
const IN_WORLDS =
  'x3d, inline, x3d-rigid-body-collection, rigidbodycollection, x3d-rigid-body, rigidbody';

export class Stage {
  readonly page: ScenePage;
  private readonly live: LiveTree;
  private readonly tags: ReadonlySet<string>;
  /** Of elements that no world has, for instance outside any scene. */
  private readonly strays = new Set<Problem>();
  private isPaused = false;

  constructor(page: ScenePage, ownTags: readonly string[]) {
    this.page = page;
    const own = new Set(ownTags);
    this.live = new LiveTree(
      page.document.body,
      ({ localName }) => own.has(localName),
      (element, attribute) => x3domDefault(page, element, attribute),
    );
    this.tags = new Set([...x3domTags(page), ...ownTags]);
    // A world that comes later waits as the others do.
    page.document.addEventListener('physicsready', () => (this.paused = this.isPaused));
    page.document.addEventListener('physicsproblem', (event: Event) =>
      this.strays.add((event as CustomEvent<Problem>).detail),
    );
  }

  static async open(parent: HTMLElement, site: string, ownTags: readonly string[]): Promise<Stage> {
    return new Stage(await openScenePage(parent, site), ownTags);
  }

  /** Answers what of it is not shown. */
  bringTo(roots: readonly TreeNode[]): LeftOut[] {
    const cleaned = clean(roots, this.tags);
    this.live.bringTo(whole(cleaned.roots));
    this.paused = this.isPaused;
    return cleaned.leftOut;
  }

  beginAnew(roots: readonly TreeNode[]): LeftOut[] {
    this.live.clear();
    return this.bringTo(roots);
  }

  /** What is shown of a text, by itself. */
  shownOf(roots: readonly TreeNode[]): TreeNode[] {
    return whole(clean(roots, this.tags).roots);
  }

  get worlds(): World[] {
    const elements = this.page.document.body.querySelectorAll(IN_WORLDS);
    const worlds = [...elements].map((element) => this.page.worldOf!(element));
    return [...new Set(worlds)].filter((world) => !!world);
  }

  get paused(): boolean {
    return this.isPaused;
  }

  set paused(paused: boolean) {
    this.isPaused = paused;
    for (const world of this.worlds) world.paused = paused;
  }

  step(): void {
    this.paused = true;
    for (const world of this.worlds) world.step(1);
  }

  get problems(): Told[] {
    const inWorlds = this.worlds.flatMap(({ problems }) => problems);
    return [...inWorlds, ...this.standingStrays(inWorlds)].map((problem) => ({
      problem,
      source: this.live.sourceOf(elementOf(problem)),
    }));
  }

  /** The element's state says whether it is still so. */
  private standingStrays(inWorlds: readonly Problem[]): Problem[] {
    for (const stray of this.strays) {
      const element = elementOf(stray);
      const isInWorld = inWorlds.some((other) => other.message === stray.message);
      const stands = element?.isConnected && element.matches(':state(problem)');
      if (isInWorld || !stands) this.strays.delete(stray);
    }
    return [...this.strays];
  }
}

/** A problem names its element, or the name of a node that has none. */
const elementOf = ({ element }: Problem): Element | null =>
  typeof element === 'object' ? (element as Element | null) : null;
