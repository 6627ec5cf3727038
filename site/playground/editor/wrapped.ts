// A line that is wrapped goes on below its own beginning, two letters further in, and not at the edge of the text.
import type { Extension, Line } from '@codemirror/state';
import {
  Decoration,
  EditorView,
  ViewPlugin,
  type DecorationSet,
  type ViewUpdate,
} from '@codemirror/view';

/** Letters; text that begins further in has no place left to be wrapped in. */
const MORE = 2;
const MOST = 24;

function indentOf({ text }: Line, tabSize: number): number {
  const [start] = /^\s*/.exec(text)!;
  const letters = [...start].reduce((sum, each) => sum + (each === '\t' ? tabSize : 1), 0);
  return Math.min(letters, MOST) + MORE;
}

const indented = (letters: number): Decoration =>
  Decoration.line({ attributes: { class: 'wrapped', style: `--letters: ${letters}ch` } });

function decorationsOf({ visibleRanges, state }: EditorView): DecorationSet {
  const found = new Map<number, Decoration>();
  for (const { from, to } of visibleRanges) {
    for (let at = from; at <= to;) {
      const line = state.doc.lineAt(at);
      found.set(line.from, indented(indentOf(line, state.tabSize)));
      at = line.to + 1;
    }
  }
  return Decoration.set([...found].map(([at, decoration]) => decoration.range(at)));
}

class Indents {
  decorations: DecorationSet;

  constructor(view: EditorView) {
    this.decorations = decorationsOf(view);
  }

  update({ docChanged, viewportChanged, view }: ViewUpdate): void {
    if (docChanged || viewportChanged) this.decorations = decorationsOf(view);
  }
}

export const indentWrapped: Extension = ViewPlugin.fromClass(Indents, {
  decorations: ({ decorations }) => decorations,
});
