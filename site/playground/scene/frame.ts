// The page that a scene stands in: a frame of its own in a sandbox. Its scripts run as in any page, and see and change
// nothing of the site: neither its pages nor what it keeps. Nothing of a scene outlives its frame.
import shadows from '../../kit/shadows.js?raw';
import inside from './inside.js?raw';
import type { Made } from './live.js';

/** What a scene's page tells. Scripts of the text stand beside who tells it: it is shown as words, and nothing else. */
export interface Told {
  state?: State;
  answer?: { number: number; value: unknown };
  fault?: ScriptFault;
  /** Dropped on the scene. */
  file?: File;
}

export interface State {
  /** Seconds. */
  time: number;
  problems: Problem[];
  /** Whether it is recorded, or a run is looked at. */
  recording: boolean;
  playing: boolean;
  /** The last request that is done. */
  done: number;
}

export interface Problem {
  code: string;
  severity: 'error' | 'warning' | 'info';
  message: string;
  attribute: string | null;
  /** The number of what the text has of it. */
  source: number | null;
}

export interface ScriptFault {
  message: string;
  /** The script's number; null where it is no script of the text. */
  id: number | null;
  /** From the script's first. */
  line: number;
}

/** What x3dom knows. */
export interface X3domWords {
  /** In lower case. */
  tags: string[];
  /** In X3D's case, with the fields and their defaults as text. */
  nodes: [name: string, fields: [name: string, value: string][]][];
}

export interface Request {
  ask: 'edit' | 'clear' | 'pause' | 'step' | 'panel' | 'scheme' | Recording | Question;
  what?: unknown;
  number: number;
}

type Recording = 'record' | 'play';
type Question = 'words' | 'runs' | 'show';

/** With what a page begins. */
export interface Begin {
  roots: Made[];
  ownTags: readonly string[];
  paused: boolean;
  panel: boolean;
  scheme: Scheme;
}

export type Scheme = 'light' | 'dark' | 'light dark';

/** Beside what every live example has (site/markdown/frame.css): a page's own <main>, and the panel. */
const STYLE = `
html { display: flex }
body { flex: 1; min-width: 0 }
main { flex: 1; min-height: 0; display: flex; flex-direction: column }
body:has(> main) { margin: 0 }
aside { flex: 0 0 330px; overflow: auto; padding: 8px; display: grid; gap: 8px; align-content: start; background: light-dark(#eef1f4, #1b1b1f) }
@media (max-width: 600px) {
  html { flex-direction: column; height: auto }
  body { flex: none; height: 300px; height: max(300px, 46dvh) }
  aside { flex: none }
}`;

/** `site` is the whole address where it lies. */
function pageOf(site: string, begin: Begin): string {
  const nonce = crypto.randomUUID();
  const library = `${site}x3d-physics/x3d-physics.single.js`;
  const allowed = `'nonce-${nonce}' 'wasm-unsafe-eval' ${site}x3d-physics/ ${site}x3dom/`;
  const policy = `script-src ${allowed}; object-src 'none'; frame-src 'none'; base-uri 'none'; form-action 'none'`;
  // No script's end can stand in it.
  const given = JSON.stringify({ nonce, library, ...begin }).replaceAll('<', '\\u003c');
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<base target="_blank">
<title>The scene</title>
<link rel="stylesheet" href="${site}x3dom/x3dom.css">
<link rel="stylesheet" href="${site}frame.css">
<style>${STYLE}</style>
<script src="${site}x3dom/x3dom.js"></script>
<script src="${library}"></script>
<script type="module" nonce="${nonce}">${shadows}</script>
<body><script type="application/json" id="given">${given}</script><script nonce="${nonce}">${inside}</script></body>`;
}

export class ScenePage {
  private readonly frame = document.createElement('iframe');
  private readonly heard: (told: Told) => void;
  private port: MessagePort | undefined;
  private waiting: Request[] = [];
  private readonly answered = new Map<number, (value: never) => void>();
  private asked = 0;
  private done = 0;
  /** When its own script runs. */
  readonly ready: Promise<void>;

  constructor(parent: HTMLElement, site: string, begin: Begin, heard: (told: Told) => void) {
    this.heard = heard;
    this.frame.title = 'The scene';
    this.frame.setAttribute('sandbox', 'allow-scripts allow-popups allow-popups-to-escape-sandbox');
    // x3dom asks at its start whether there are glasses.
    this.frame.allow = 'xr-spatial-tracking *; fullscreen *';
    this.frame.srcdoc = pageOf(site, begin);
    this.ready = this.connect();
    parent.replaceChildren(this.frame);
  }

  /** Whether something asked for is still to be done. */
  get busy(): boolean {
    return !this.port || this.done < this.asked;
  }

  ask(ask: Request['ask'], what?: unknown): void {
    this.waiting.push({ ask, what, number: ++this.asked });
    this.send();
  }

  /** A page that is closed answers nothing. */
  answer<T>(question: Question, what?: unknown): Promise<T> {
    return new Promise((resolve) => {
      this.ask(question, what);
      this.answered.set(this.asked, resolve);
    });
  }

  close(): void {
    this.port?.close();
    this.frame.remove();
  }

  private send(): void {
    if (!this.port || this.waiting.length === 0) return;
    this.port.postMessage(this.waiting);
    this.waiting = [];
  }

  /** The first message is of its own script, which runs before any other that could send one. */
  private connect(): Promise<void> {
    return new Promise((resolve, reject) => {
      const hear = ({ source, data, ports }: MessageEvent) => {
        if (source !== this.frame.contentWindow || !ports[0]) return;
        removeEventListener('message', hear);
        if (data.missing) reject(new Error(`${data.missing} did not load.`));
        [this.port] = ports;
        this.port!.onmessage = ({ data: told }: MessageEvent<Told>) => this.listen(told);
        this.send();
        resolve();
      };
      addEventListener('message', hear);
    });
  }

  private listen(told: Told): void {
    const { state, answer } = told;
    if (state) this.done = state.done;
    if (answer) this.answered.get(answer.number)?.(answer.value as never);
    this.heard(told);
  }
}
