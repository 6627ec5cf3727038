// The text, the scene and the buttons, and what each does to the others.
import type { Diagnostic } from '@codemirror/lint';
import { exampleHash, markupIn, sharedHash } from './address.js';
import { isOfText, ofFault, ofLeftOut, ofProblem, ofScript } from './diagnostics.js';
import { pageOf, save } from './download.js';
import { createEditor, type Editor } from './editor/editor.js';
import { Vocabulary, type Manifest } from './editor/vocabulary.js';
import { fillMenu, type Example } from './examples.js';
import { Stage } from './scene/stage.js';
import { showScripts } from './script-list.js';
import type { LeftOut } from './text/left-out.js';
import { parse, type Fault } from './text/parse.js';
import type { TreeNode } from './text/tree.js';
import { showTold } from './told.js';
import type { View } from './view.js';

export class Playground {
  private readonly view: View;
  private readonly site: string;
  private readonly examples: readonly Example[];
  private readonly vocabulary: Vocabulary;
  private readonly editor: Editor;
  private readonly stage: Stage;
  /** The last text that was well-formed. */
  private roots: TreeNode[] = [];
  private rootsText = '';
  private leftOut: LeftOut[] = [];
  private fault: Fault | undefined;
  private isOpening = false;
  private shown = '';

  /** `site` is the whole address where it lies. */
  constructor(view: View, site: string, manifest: Manifest, examples: readonly Example[]) {
    this.view = view;
    this.site = site;
    this.examples = examples;
    this.vocabulary = new Vocabulary(manifest);
    this.stage = new Stage(view.scene, site, this.vocabulary.names, () => this.look());
    this.editor = createEditor(view.text, this.vocabulary, (text) => this.textChanged(text));
    fillMenu(view.menu, examples, site);
    this.listen();
  }

  async openScene(): Promise<void> {
    this.vocabulary.addX3dom(await this.stage.words());
  }

  /** What the address holds; where it holds nothing, `otherwise`. */
  async openAddress(otherwise?: Example): Promise<void> {
    try {
      const found = await markupIn(location.hash, this.examples);
      const { markup } = found ?? otherwise ?? {};
      if (markup === undefined) return;
      this.open(markup);
      const example = this.exampleOf(markup) ?? found?.example;
      this.view.menu.value = example?.id ?? '';
      if (found && markup === example?.markup) this.putAddress(exampleHash(example));
    } catch (error) {
      if (otherwise) this.openExample(otherwise);
      this.tell((error as Error).message);
    }
  }

  end(): void {
    this.stage.end();
    this.editor.destroy();
  }

  /** Another text, from its beginning. */
  private open(markup: string): void {
    this.isOpening = true;
    this.roots = [];
    this.editor.open(markup);
    this.isOpening = false;
    this.reset();
    this.tell('');
  }

  private openExample(example: Example): void {
    this.open(example.markup);
    this.view.menu.value = example.id;
  }

  private exampleOf(markup: string): Example | undefined {
    return this.examples.find((each) => each.markup === markup);
  }

  private putAddress(hash: string): void {
    history.replaceState(history.state, '', hash);
  }

  private tell(text: string): void {
    this.view.word.textContent = text;
  }

  private listen(): void {
    const { menu, pause, step, reset, panel, share, download } = this.view;
    menu.addEventListener('change', () => this.chosen(menu.value));
    pause.addEventListener('click', () => this.pause(!this.stage.paused));
    step.addEventListener('click', () => this.step());
    reset.addEventListener('click', () => this.reset());
    panel.addEventListener('click', () => this.showPanel(!this.stage.panel));
    share.addEventListener('click', () => void this.share());
    download.addEventListener('click', () => void this.download());
  }

  private chosen(id: string): void {
    const example = this.examples.find((each) => each.id === id);
    if (!example) return;
    this.openExample(example);
    this.putAddress(exampleHash(example));
  }

  private textChanged(text: string): void {
    const { roots, fault } = parse(text);
    this.fault = fault;
    if (roots) {
      this.roots = roots;
      this.rootsText = text;
      this.editor.mark();
      if (!this.isOpening) this.leftOut = this.stage.bringTo(roots);
    }
    // Undo may have led back to one.
    const example = this.exampleOf(text);
    if (example) this.view.menu.value = example.id;
    this.look();
  }

  /** An edit of CodeMirror is over before the next can be made: the marks come a moment later. */
  private look(): void {
    queueMicrotask(() => {
      const diagnostics = this.diagnostics();
      const now = JSON.stringify(diagnostics);
      if (now !== this.shown) this.show(diagnostics);
      this.shown = now;
      this.showScripts();
      this.view.time.textContent = `${this.stage.time.toFixed(2)} s`;
    });
  }

  /** Those of the scene are of the text that it was brought to last. */
  private diagnostics(): Diagnostic[] {
    const ofScene = [
      ...this.leftOut.map(ofLeftOut),
      ...this.stage.problems.filter(isOfText).map(ofProblem),
      ...this.stage.scriptFaults.map((fault) => ofScript(fault, this.rootsText)),
    ].map((each) => ({
      ...each,
      from: this.editor.now(each.from),
      to: this.editor.now(each.to),
    }));
    const all = this.fault ? [ofFault(this.fault), ...ofScene] : ofScene;
    return all.sort((a, b) => a.from - b.from);
  }

  private show(diagnostics: Diagnostic[]): void {
    this.editor.show(diagnostics);
    const lines = diagnostics.map((diagnostic) => ({
      number: this.editor.lineAt(diagnostic.from),
      diagnostic,
    }));
    showTold(this.view.told, lines, (diagnostic) => this.editor.goTo(diagnostic));
  }

  private showScripts(): void {
    const scripts = this.stage.scripts.map((source) => ({
      source,
      line: this.editor.lineAt(this.editor.now(source.from)),
    }));
    showScripts(this.view.scripts, scripts, ({ source: { from, to } }) =>
      this.editor.goTo({ from: this.editor.now(from), to: this.editor.now(to) }),
    );
  }

  private pause(paused: boolean): void {
    this.stage.paused = paused;
    this.view.pause.textContent = paused ? 'Go on' : 'Pause';
    this.view.pause.setAttribute('aria-pressed', String(paused));
  }

  private step(): void {
    this.pause(true);
    this.stage.step();
  }

  private reset(): void {
    this.leftOut = this.stage.beginAnew(this.roots);
    this.look();
  }

  private showPanel(open: boolean): void {
    this.stage.panel = open;
    this.view.panel.setAttribute('aria-pressed', String(open));
    this.view.scene.parentElement!.classList.toggle('with-panel', open);
  }

  private async share(): Promise<void> {
    const example = this.examples.find(({ id }) => id === this.view.menu.value);
    this.putAddress(await sharedHash(this.editor.text, example));
    try {
      await navigator.clipboard.writeText(location.href);
      this.tell(`Copied: an address of ${location.href.length} letters that holds the whole text.`);
    } catch {
      // No clipboard without HTTPS, except at localhost.
      this.tell("The page's address now holds the whole text: copy it from the address bar.");
    }
  }

  private async download(): Promise<void> {
    try {
      save('scene.html', await pageOf(this.stage.shownOf(this.roots), this.site));
      this.tell('Saved: one page, which runs by double click and without a network.');
    } catch (error) {
      this.tell((error as Error).message);
    }
  }
}
