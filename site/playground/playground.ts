// The text, the scene and the buttons, and what each does to the others.
import type { Diagnostic } from '@codemirror/lint';
import { exampleHash, foundIn, sharedHash } from './address.js';
import {
  isOfRun,
  isOfText,
  ofFault,
  ofLeftOut,
  ofProblem,
  ofRunFault,
  ofScript,
} from './diagnostics.js';
import { pageOf, save } from './download.js';
import { createEditor, type Editor } from './editor/editor.js';
import { Vocabulary, type Manifest } from './editor/vocabulary.js';
import { fillMenu, type Example } from './examples.js';
import { chooseFile, fileOf, LONGEST, runsIn, sharedIn, takeDropped, withRuns } from './run.js';
import { Stage } from './scene/stage.js';
import { showScripts } from './script-list.js';
import type { LeftOut } from './text/left-out.js';
import { parse, type Fault } from './text/parse.js';
import type { TreeNode } from './text/tree.js';
import { showTold } from './told.js';
import type { View } from './view.js';

const RECORDING = 'Recorded from the beginning: Share takes it along, and Record ends it.';
const ENDED = 'No longer recorded: the text has other nodes now.';
const LOOKING = 'A recorded run: Play shows it, and Record goes on from where one looks.';

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
  /** Why what was recorded is not shown. */
  private runFault: string | undefined;
  private isOpening = false;
  private shown = '';

  /** `site` is the whole address where it lies. */
  constructor(view: View, site: string, manifest: Manifest, examples: readonly Example[]) {
    this.view = view;
    this.site = site;
    this.examples = examples;
    this.vocabulary = new Vocabulary(manifest);
    const { names } = this.vocabulary;
    const openFile = (file: File) => void this.openFile(file);
    this.stage = new Stage(view.scene, site, names, () => this.look(), openFile);
    this.editor = createEditor(view.text, this.vocabulary, (text) => this.textChanged(text));
    fillMenu(view.menu, examples, site);
    this.listen();
    takeDropped(view.scene.closest('.x3d-playground')!, openFile);
  }

  async openScene(): Promise<void> {
    this.vocabulary.addX3dom(await this.stage.words());
  }

  /** What the address holds; where it holds nothing, `otherwise`. */
  async openAddress(otherwise?: Example): Promise<void> {
    try {
      const found = await foundIn(location.hash, this.examples);
      const { markup } = found ?? otherwise ?? {};
      if (markup === undefined) return;
      this.open(markup);
      const example = this.exampleOf(markup) ?? found?.example;
      this.view.menu.value = example?.id ?? '';
      if (found?.run !== undefined) void this.showRuns(runsIn(found.run));
      else if (found && markup === example?.markup) this.putAddress(exampleHash(example));
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

  /** What was saved as a file; where it can't be read, the scene is as it was. */
  private async openFile(file: File): Promise<void> {
    try {
      const { markup, runs } = await sharedIn(file);
      this.open(markup);
      this.view.menu.value = this.exampleOf(markup)?.id ?? '';
      await this.showRuns(runs);
    } catch (error) {
      this.runFault = (error as Error).message;
      this.look();
    }
  }

  /** Stands at the beginning of what was recorded, or says why it does not. */
  private async showRuns(runs: unknown[] | Promise<unknown[]>): Promise<void> {
    const { roots } = this;
    const fault = await Promise.resolve(runs)
      .then((all) => this.stage.showRuns(all))
      .catch((error: Error) => error.message);
    // Another text may have been opened meanwhile.
    if (roots !== this.roots) return;
    this.runFault = fault;
    if (!fault) this.tell(LOOKING);
    this.look();
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
    const { menu, pause, step, reset, record, play, panel, share, download, open } = this.view;
    menu.addEventListener('change', () => this.chosen(menu.value));
    pause.addEventListener('click', () => this.pause(!this.stage.paused));
    step.addEventListener('click', () => this.step());
    reset.addEventListener('click', () => this.reset());
    record.addEventListener('click', () => this.record(!this.stage.recording));
    play.addEventListener('click', () => this.stage.play(!this.stage.playing));
    panel.addEventListener('click', () => this.showPanel(!this.stage.panel));
    share.addEventListener('click', () => void this.share());
    download.addEventListener('click', () => void this.download());
    open.addEventListener('click', () => chooseFile((file) => void this.openFile(file)));
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
      if (!this.isOpening) this.bringTo(roots);
    }
    // Undo may have led back to one.
    const example = this.exampleOf(text);
    if (example) this.view.menu.value = example.id;
    this.look();
  }

  private bringTo(roots: TreeNode[]): void {
    const { recording } = this.stage;
    this.leftOut = this.stage.bringTo(roots);
    if (recording && !this.stage.recording) this.tell(ENDED);
  }

  /** An edit of CodeMirror is over before the next can be made: the marks come a moment later. */
  private look(): void {
    queueMicrotask(() => {
      const all = [this.ofRun(), this.ofText()] as const;
      const now = JSON.stringify(all);
      if (now !== this.shown) this.show(...all);
      this.shown = now;
      this.showScripts();
      this.showRecording();
      this.view.time.textContent = `${this.stage.time.toFixed(2)} s`;
    });
  }

  private ofRun(): Diagnostic[] {
    const faults = this.runFault ? [ofRunFault(this.runFault)] : [];
    return [...faults, ...this.stage.problems.filter(isOfRun).map(ofProblem)];
  }

  /** Those of the scene are of the text that it was brought to last. */
  private ofText(): Diagnostic[] {
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

  private show(ofRun: Diagnostic[], ofText: Diagnostic[]): void {
    this.editor.show(ofText);
    const lines = [
      ...ofRun.map((diagnostic) => ({ number: undefined, diagnostic })),
      ...ofText.map((diagnostic) => ({
        number: this.editor.lineAt(diagnostic.from),
        diagnostic,
      })),
    ];
    showTold(this.view.told, lines, (diagnostic) => this.editor.goTo(diagnostic));
  }

  private showRecording(): void {
    const { record, play } = this.view;
    record.setAttribute('aria-pressed', String(this.stage.recording));
    play.hidden = !this.stage.recording;
    play.textContent = this.stage.playing ? 'Hold' : 'Play';
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
    this.runFault = undefined;
    this.leftOut = this.stage.beginAnew(this.roots);
    this.look();
  }

  /** Begins anew, so that nodes get the numbers that they get wherever the text is opened. */
  private record(on: boolean): void {
    if (on) this.reset();
    this.stage.record(on);
    this.tell(on ? RECORDING : '');
    this.look();
  }

  private showPanel(open: boolean): void {
    this.stage.panel = open;
    this.view.panel.setAttribute('aria-pressed', String(open));
    this.view.scene.parentElement!.classList.toggle('with-panel', open);
  }

  private async share(): Promise<void> {
    const example = this.examples.find(({ id }) => id === this.view.menu.value);
    if (this.stage.recording) return this.shareRun(example);
    this.putAddress(await sharedHash(this.editor.text, example));
    await this.copyAddress('the whole text');
  }

  /** The scene is that of the last text that was well-formed. */
  private async shareRun(example: Example | undefined): Promise<void> {
    try {
      const [markup, runs] = [this.rootsText, await this.stage.runs()];
      const hash = await withRuns(await sharedHash(markup, example), runs);
      const { length } = new URL(hash, location.href).href;
      if (length <= LONGEST) {
        this.putAddress(hash);
        await this.copyAddress('the whole text and what was recorded');
        return;
      }
      save('scene-and-run.json', fileOf({ markup, runs }));
      this.tell(`Saved as a file, for Open run: its address would have ${length} letters.`);
    } catch (error) {
      this.tell((error as Error).message);
    }
  }

  private async copyAddress(what: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(location.href);
      this.tell(`Copied: an address of ${location.href.length} letters that holds ${what}.`);
    } catch {
      // No clipboard without HTTPS, except at localhost.
      this.tell(`The page's address now holds ${what}: copy it from the address bar.`);
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
