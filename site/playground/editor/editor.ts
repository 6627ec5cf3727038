// The text: CodeMirror in the language that the text is in, with the words of X3D.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete';
import {
  defaultKeymap,
  history,
  historyKeymap,
  indentWithTab,
  isolateHistory,
} from '@codemirror/commands';
import { html } from '@codemirror/lang-html';
import { xml as xmlSupport } from '@codemirror/lang-xml';
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  syntaxHighlighting,
} from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { Compartment, Prec, Transaction, type ChangeDesc, type Extension } from '@codemirror/state';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { isXml } from '../text/parse.js';
import type { Place } from '../text/tree.js';
import { closeTags } from './close.js';
import { completion, hover } from './complete.js';
import type { Vocabulary } from './vocabulary.js';
import { indentWrapped } from './wrapped.js';

const colors = HighlightStyle.define([
  { tag: tags.tagName, color: 'var(--tag)' },
  { tag: tags.attributeName, color: 'var(--attribute)' },
  { tag: [tags.attributeValue, tags.string], color: 'var(--value)' },
  { tag: [tags.comment, tags.meta, tags.processingInstruction], color: 'var(--aside)' },
  { tag: [tags.keyword, tags.controlKeyword, tags.definitionKeyword], color: 'var(--attribute)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--tag)' },
  { tag: [tags.angleBracket, tags.definitionOperator], color: 'var(--aside)' },
]);

/** Milliseconds after Escape for which Tab leaves the text. */
const TO_LEAVE = 3000;

const handling: Extension = [
  lineNumbers(),
  history(),
  drawSelection(),
  indentOnInput(),
  bracketMatching(),
  closeBrackets(),
  highlightActiveLine(),
  highlightSelectionMatches(),
  keymap.of([
    ...closeBracketsKeymap,
    ...completionKeymap,
    ...defaultKeymap,
    ...historyKeymap,
    ...lintKeymap,
    ...searchKeymap,
    indentWithTab,
  ]),
];

/** Where something is selected, Escape is taken for that first; Tab leaves all the same. */
const wayOut = Prec.highest(
  keymap.of([
    {
      key: 'Escape',
      run(view) {
        view.setTabFocusMode(TO_LEAVE);
        return false;
      },
    },
  ]),
);

/** Scripts and styles of HTML are in their own languages; words of tags are offered by complete.ts. */
const languageOf = (xml: boolean): Extension => (xml ? xmlSupport() : html());

export interface Editor {
  readonly text: string;
  /** Another text. Undo leads back to the one before, if there was any. */
  open(text: string): void;
  /** Places that are asked for from now on are those of the present text. */
  mark(): void;
  /** Where a place of the marked text is now. */
  now(place: number): number;
  lineAt(place: number): number;
  goTo(place: Place): void;
  show(diagnostics: readonly Diagnostic[]): void;
  destroy(): void;
}

export function createEditor(
  parent: HTMLElement,
  vocabulary: Vocabulary,
  changed: (text: string) => void,
): Editor {
  const language = new Compartment();
  let xml = false;
  /** What has changed since the mark. */
  let since: ChangeDesc | undefined;

  function textChanged(text: string): void {
    if (isXml(text) !== xml) {
      xml = !xml;
      view.dispatch({ effects: language.reconfigure(languageOf(xml)) });
    }
    changed(text);
  }

  const view = new EditorView({
    parent,
    extensions: [
      wayOut,
      closeTags,
      handling,
      language.of(languageOf(xml)),
      syntaxHighlighting(colors),
      completion(vocabulary),
      hover(vocabulary),
      lintGutter(),
      EditorView.lineWrapping,
      indentWrapped,
      EditorView.contentAttributes.of({
        'aria-label': 'Markup of the scene',
        'aria-describedby': 'playground-keys',
        tabindex: '0',
      }),
      EditorView.updateListener.of(({ docChanged, changes, state }) => {
        if (!docChanged) return;
        since = since ? since.composeDesc(changes.desc) : changes.desc;
        textChanged(state.doc.toString());
      }),
    ],
  });

  const inside = (place: number): number => Math.min(Math.max(0, place), view.state.doc.length);

  return {
    get text() {
      return view.state.doc.toString();
    },
    open(insert) {
      const { length } = view.state.doc;
      view.dispatch({
        changes: { from: 0, to: length, insert },
        selection: { anchor: 0 },
        scrollIntoView: true,
        // There is nothing before the first text to go back to.
        annotations: length === 0 ? Transaction.addToHistory.of(false) : isolateHistory.of('full'),
      });
    },
    mark: () => (since = undefined),
    now: (place) => inside(since && place <= since.length ? since.mapPos(place) : place),
    lineAt: (place) => view.state.doc.lineAt(inside(place)).number,
    goTo({ from, to }) {
      const selection = { anchor: inside(from), head: inside(to) };
      view.dispatch({
        selection,
        effects: EditorView.scrollIntoView(selection.anchor, { y: 'center' }),
      });
      view.focus();
    },
    show: (diagnostics) => view.dispatch(setDiagnostics(view.state, [...diagnostics])),
    destroy: () => view.destroy(),
  };
}
