// The scene beside the text: it begins anew from a text, or is brought to one while it runs.
import { clean, type LeftOut } from '../text/left-out.js';
import { scriptsIn } from '../text/scripts.js';
import type { ElementNode, TreeNode } from '../text/tree.js';
import { whole } from '../text/whole.js';
import {
  ScenePage,
  type Problem,
  type Scheme,
  type ScriptFault,
  type Told,
  type X3domWords,
} from './frame.js';
import { LiveTree, type Edit } from './live.js';

/** What is said of the scene, and what the text has of it. */
export interface Said<T> {
  said: T;
  source: ElementNode | undefined;
}

/** Milliseconds without an edit after which scripts that changed begin anew. */
const PATIENCE = 700;

/** Words of one page about its scripts: one that fails in every frame may say each time something else. */
const MOST = 20;

const isSame =
  ({ message, id, line }: ScriptFault) =>
  (other: ScriptFault): boolean =>
    message === other.message && id === other.id && line === other.line;

/** Nodes come, go or move. */
const isOfNodes = ({ do: what }: Edit): boolean => what !== 'set' && what !== 'write';

/** What makes scripts other ones. */
const signOf = (scripts: readonly ElementNode[]): string =>
  JSON.stringify(
    scripts.map(({ attributes, children }) => [
      [...attributes].map(([key, { value }]) => [key, value]),
      children,
    ]),
  );

/** The site's switch, where there is one, or the system's. */
function schemeOf(place: Element): Scheme {
  const { colorScheme } = getComputedStyle(place);
  return colorScheme === 'normal' ? 'light' : (colorScheme as Scheme);
}

export class Stage {
  private readonly parent: HTMLElement;
  private readonly site: string;
  private readonly ownTags: readonly string[];
  private readonly told: () => void;
  private readonly dropped: (file: File) => void;
  private readonly live: LiveTree;
  private page: ScenePage;
  private tags: ReadonlySet<string> = new Set();
  private roots: TreeNode[] = [];
  private running = '[]';
  private restart: ReturnType<typeof setTimeout> | undefined;
  private isPaused = false;
  private hasPanel = false;
  private faults: ScriptFault[] = [];
  private all: Problem[] = [];
  private readonly switched = new MutationObserver(() => {
    this.page.ask('scheme', schemeOf(this.parent));
    this.markBusy();
  });
  /** Seconds. */
  time = 0;
  /** Whether it is recorded, or a run is looked at. */
  recording = false;
  playing = false;

  /** `told`: the scene told something; `dropped`: a file was dropped on it. */
  constructor(
    parent: HTMLElement,
    site: string,
    ownTags: readonly string[],
    told: () => void,
    dropped: (file: File) => void,
  ) {
    this.parent = parent;
    this.site = site;
    this.ownTags = ownTags;
    this.told = told;
    this.dropped = dropped;
    const own = new Set(ownTags);
    this.live = new LiveTree((tag) => own.has(tag));
    this.page = this.open([]);
    this.switched.observe(document.documentElement, { attributeFilter: ['class'] });
  }

  /** What x3dom knows; until then nothing of a text is shown. */
  async words(): Promise<X3domWords> {
    await this.page.ready;
    const words = await this.page.answer<X3domWords>('words');
    this.tags = new Set([...words.tags, ...this.ownTags]);
    return words;
  }

  /** Answers what of it is not shown. */
  bringTo(roots: readonly TreeNode[]): LeftOut[] {
    const leftOut = this.take(roots);
    clearTimeout(this.restart);
    this.restart = undefined;
    if (signOf(this.scripts) === this.running) this.patch();
    else this.restart = setTimeout(() => this.restartNow(), PATIENCE);
    this.markBusy();
    return leftOut;
  }

  /** Scripts run from their beginning; a scene without any begins anew in the page that is there. */
  beginAnew(roots: readonly TreeNode[]): LeftOut[] {
    const leftOut = this.take(roots);
    const hadScripts = this.running !== '[]';
    clearTimeout(this.restart);
    this.restart = undefined;
    if (hadScripts || this.scripts.length > 0) this.restartNow();
    else {
      this.recording = this.playing = false;
      this.page.ask('clear');
      this.live.begin([]);
      this.patch();
    }
    this.markBusy();
    return leftOut;
  }

  /** What is shown of a text, by itself. */
  shownOf(roots: readonly TreeNode[]): TreeNode[] {
    return whole(clean(roots, this.tags).roots);
  }

  get paused(): boolean {
    return this.isPaused;
  }

  set paused(paused: boolean) {
    this.isPaused = paused;
    this.page.ask('pause', paused);
    this.markBusy();
  }

  get panel(): boolean {
    return this.hasPanel;
  }

  set panel(open: boolean) {
    this.hasPanel = open;
    this.page.ask('panel', open);
  }

  step(): void {
    this.isPaused = true;
    this.page.ask('step');
    this.markBusy();
  }

  record(on: boolean): void {
    this.recording = on;
    this.page.ask('record', on);
    this.markBusy();
  }

  play(on: boolean): void {
    this.page.ask('play', on);
    this.markBusy();
  }

  /** Of each world, what was recorded. */
  runs(): Promise<unknown[]> {
    return this.page.answer('runs');
  }

  /** Stands at the beginning of what was recorded elsewhere; answers why it does not. */
  showRuns(runs: unknown[]): Promise<string | undefined> {
    return this.page.answer('show', runs);
  }

  /** Those of the text that was given last. */
  get scripts(): ElementNode[] {
    return scriptsIn(this.roots);
  }

  get problems(): Said<Problem>[] {
    return this.all.map((said) => ({ said, source: this.live.sourceOf(said.source) }));
  }

  get scriptFaults(): Said<ScriptFault>[] {
    return this.faults.map((said) => ({ said, source: this.live.sourceOf(said.id) }));
  }

  end(): void {
    clearTimeout(this.restart);
    this.switched.disconnect();
    this.page.close();
  }

  private take(roots: readonly TreeNode[]): LeftOut[] {
    const cleaned = clean(roots, this.tags);
    this.roots = whole(cleaned.roots);
    return cleaned.leftOut;
  }

  private patch(): void {
    const edits = this.live.bringTo(this.roots);
    // Nodes have other numbers in a page that begins with the text as it is now: a run would not fit.
    if (this.recording && edits.some(isOfNodes)) this.record(false);
    if (edits.length > 0) this.page.ask('edit', edits);
  }

  private restartNow(): void {
    this.restart = undefined;
    this.page.close();
    this.page = this.open(this.roots);
    this.markBusy();
  }

  private open(roots: readonly TreeNode[]): ScenePage {
    this.running = signOf(scriptsIn(roots));
    this.faults = [];
    this.time = 0;
    this.recording = this.playing = false;
    this.all = [];
    const begin = {
      roots: this.live.begin(roots),
      ownTags: this.ownTags,
      paused: this.isPaused,
      panel: this.hasPanel,
      scheme: schemeOf(this.parent),
    };
    const page = new ScenePage(this.parent, this.site, begin, (told) => {
      if (page === this.page) this.hear(told);
    });
    void page.ready.then(() => this.markBusy()).catch(() => {});
    return page;
  }

  private hear({ state, fault, file }: Told): void {
    if (state) {
      ({ time: this.time, recording: this.recording, playing: this.playing } = state);
      this.all = state.problems;
    }
    if (fault && this.faults.length < MOST && !this.faults.some(isSame(fault)))
      this.faults.push(fault);
    if (file) this.dropped(file);
    this.markBusy();
    this.told();
  }

  private markBusy(): void {
    this.parent.setAttribute('aria-busy', String(this.page.busy || this.restart !== undefined));
  }
}
