// The text, the scene and the buttons, and what each does to the others.
import type { Diagnostic } from '@codemirror/lint';
import { sharedHash } from './address.js';
import { isOfText, ofFault, ofLeftOut, ofProblem } from './diagnostics.js';
import { download, pageOf } from './download.js';
import { createEditor, type Editor } from './editor/editor.js';
import { Vocabulary, type Manifest } from './editor/vocabulary.js';
import { fillMenu, type Example } from './examples.js';
import { Stage } from './scene/stage.js';
import { parse } from './text/parse.js';
import type { TreeNode } from './text/tree.js';
import type { View } from './view.js';

/** Milliseconds between two looks at the worlds: their time, their problems. */
const LOOK = 250;

export class Playground {
  private readonly view: View;
  private readonly examples: readonly Example[];
  private readonly vocabulary: Vocabulary;
  private readonly editor: Editor;
  private stage: Stage | undefined;
  /** The last text that was well-formed. */
  private roots: TreeNode[] = [];
  /** What is said of the text itself. */
  private ofText: Diagnostic[] = [];
  private isBroken = false;
  private isOpening = false;
  private shown = '';
  private readonly timer = setInterval(() => this.look(), LOOK);

  constructor(view: View, manifest: Manifest, examples: readonly Example[]) {
    this.view = view;
    this.examples = examples;
    this.vocabulary = new Vocabulary(manifest);
    this.editor = createEditor(view.text, this.vocabulary, (text) => this.textChanged(text));
    fillMenu(view.menu, examples);
    this.listen();
  }

  async openScene(site: string): Promise<void> {
    this.stage = await Stage.open(this.view.scene, site, this.vocabulary.names);
    this.vocabulary.addX3dom(this.stage.page);
  }

  /** Another text, from its beginning. */
  open(markup: string): void {
    this.isOpening = true;
    this.editor.text = markup;
    this.isOpening = false;
    this.reset();
    this.tell('');
  }

  tell(text: string): void {
    this.view.word.textContent = text;
  }

  end(): void {
    clearInterval(this.timer);
    this.editor.destroy();
  }

  private listen(): void {
    const { menu, pause, step, reset, share, download: save } = this.view;
    menu.addEventListener('change', () => this.openExample());
    pause.addEventListener('click', () => this.pause(!this.stage?.paused));
    step.addEventListener('click', () => this.step());
    reset.addEventListener('click', () => this.reset());
    share.addEventListener('click', () => void this.share());
    save.addEventListener('click', () => this.download());
  }

  private openExample(): void {
    const example = this.examples[Number(this.view.menu.value)];
    if (this.view.menu.value && example) this.open(example.markup);
    // The same one can be opened again.
    this.view.menu.value = '';
  }

  private textChanged(text: string): void {
    const { roots, fault } = parse(text);
    this.isBroken = !!fault;
    if (fault) this.ofText = [ofFault(fault)];
    if (roots) {
      this.roots = roots;
      if (!this.isOpening) this.ofText = this.stage?.bringTo(roots).map(ofLeftOut) ?? [];
    }
    this.look();
  }

  /** An edit of CodeMirror is over before the next can be made: the marks come a moment later. */
  private look(): void {
    queueMicrotask(() => {
      if (!this.stage) return;
      const problems = this.isBroken ? [] : this.stage.problems.filter(isOfText).map(ofProblem);
      const diagnostics = [...this.ofText, ...problems].sort((a, b) => a.from - b.from);
      const now = JSON.stringify(diagnostics);
      if (now !== this.shown) this.editor.show(diagnostics);
      this.shown = now;
      const time = Math.max(0, ...this.stage.worlds.map((world) => world.time));
      this.view.time.textContent = `${time.toFixed(2)} s`;
    });
  }

  private pause(paused: boolean): void {
    if (this.stage) this.stage.paused = paused;
    this.view.pause.textContent = paused ? 'Go on' : 'Pause';
    this.view.pause.setAttribute('aria-pressed', String(paused));
  }

  private step(): void {
    this.pause(true);
    this.stage?.step();
    this.look();
  }

  private reset(): void {
    const leftOut = this.stage?.beginAnew(this.roots) ?? [];
    if (!this.isBroken) this.ofText = leftOut.map(ofLeftOut);
    this.look();
  }

  private async share(): Promise<void> {
    const hash = await sharedHash(this.editor.text);
    history.replaceState(history.state, '', hash);
    try {
      await navigator.clipboard.writeText(location.href);
      this.tell('Copied: an address that holds the whole text.');
    } catch {
      // No clipboard without HTTPS, except at localhost.
      this.tell("The page's address now holds the whole text: copy it from the address bar.");
    }
  }

  private download(): void {
    if (!this.stage) return;
    download('scene.html', pageOf(this.stage.shownOf(this.roots)));
    this.tell(
      'Saved. Put x3dom.js and x3d-physics.single.js beside it, and open it by double click.',
    );
  }
}
