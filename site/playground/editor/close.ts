// The end of a tag that stands there already is typed over, as a closing quote is.
import { syntaxTree } from '@codemirror/language';
import type { Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

/** Ends that a typed letter may begin. */
const ENDS = ['>', '/>'];

export const closeTags: Extension = EditorView.inputHandler.of((view, from, to, typed) => {
  if (from !== to || !/^[>/]$/.test(typed)) return false;
  const end = ENDS.find((each) => view.state.sliceDoc(from, from + each.length) === each);
  // In `<box|/>` a > ends the tag, too, but not as what stands there.
  if (!end?.startsWith(typed) || !endsTag(view, from, end)) return false;
  view.dispatch({ selection: { anchor: from + typed.length }, userEvent: 'input.type' });
  return true;
});

/** And not a value or words in which it stands. */
const endsTag = (view: EditorView, at: number, { length }: string): boolean => {
  const { name } = syntaxTree(view.state).resolveInner(at + length, -1);
  return name === 'EndTag' || name === 'SelfCloseEndTag';
};
