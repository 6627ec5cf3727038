// The text: CodeMirror in the language that the text is in, with the words of X3D.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { autoCloseTags as closeHtml, htmlLanguage } from '@codemirror/lang-html';
import { autoCloseTags as closeXml, xmlLanguage } from '@codemirror/lang-xml';
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  syntaxHighlighting,
} from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { Compartment, Prec, type Extension } from '@codemirror/state';
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
import { completion, hover } from './complete.js';
import type { Vocabulary } from './vocabulary.js';

const colors = HighlightStyle.define([
  { tag: tags.tagName, color: 'var(--tag)' },
  { tag: tags.attributeName, color: 'var(--attribute)' },
  { tag: [tags.attributeValue, tags.string], color: 'var(--value)' },
  { tag: [tags.comment, tags.meta, tags.processingInstruction], color: 'var(--aside)' },
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

const languageOf = (xml: boolean): Extension =>
  xml ? [xmlLanguage, closeXml] : [htmlLanguage, closeHtml];

export interface Editor {
  text: string;
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
      handling,
      language.of(languageOf(xml)),
      syntaxHighlighting(colors),
      completion(vocabulary),
      hover(vocabulary),
      lintGutter(),
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({
        'aria-label': 'Markup of the scene',
        'aria-describedby': 'playground-keys',
        tabindex: '0',
      }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) textChanged(update.state.doc.toString());
      }),
    ],
  });

  return {
    get text() {
      return view.state.doc.toString();
    },
    set text(insert) {
      view.dispatch({
        changes: { from: 0, to: view.state.doc.length, insert },
        scrollIntoView: true,
      });
    },
    show: (diagnostics) => view.dispatch(setDiagnostics(view.state, [...diagnostics])),
    destroy: () => view.destroy(),
  };
}
