// Completion and hover from the vocabulary.
import {
  autocompletion,
  startCompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from '@codemirror/autocomplete';
import type { Extension } from '@codemirror/state';
import { hoverTooltip, type EditorView, type Tooltip } from '@codemirror/view';
import { isXml } from '../text/parse.js';
import { VOID } from '../text/well-formed.js';
import { placeAt, type MarkupPlace } from './place.js';
import type { AttributeWord, TagWord, Vocabulary } from './vocabulary.js';

const BEFORE_CLOSED = /[\w-]/;

/** X3D's own names are for XML; in HTML x3dom's tags are written small. */
function tagName({ name }: TagWord, xml: boolean): string | undefined {
  const isOurs = name.startsWith('x3d-');
  return xml || isOurs ? name : name.toLowerCase();
}

/** Leaves the cursor between the quotes, where values are offered. */
function applyAttribute(view: EditorView, { label }: Completion, from: number, to: number): void {
  const hasValue = view.state.sliceDoc(to, to + 1) === '=';
  const insert = hasValue ? label : `${label}=""`;
  const anchor = from + insert.length - (hasValue ? 0 : 1);
  view.dispatch({
    changes: { from, to, insert },
    selection: { anchor },
    userEvent: 'input.complete',
  });
  if (!hasValue) startCompletion(view);
}

/** What may follow a tag's name where the tag is not finished. */
const UNFINISHED = /^[ \t]*($|\n|<)/;

/** Closes the tag behind the cursor, which stands where attributes come. */
const applyTag =
  (xml: boolean) =>
  (view: EditorView, { label }: Completion, from: number, to: number): void => {
    const isUnfinished = UNFINISHED.test(view.state.sliceDoc(to, to + 200));
    const end = xml ? '/>' : endOf(label);
    view.dispatch({
      changes: { from, to, insert: isUnfinished ? label + end : label },
      selection: { anchor: from + label.length },
      userEvent: 'input.complete',
    });
  };

const endOf = (tag: string): string => (VOID.test(tag) ? '>' : `></${tag}>`);

const docOf = ({ type, default: value, doc }: AttributeWord): string =>
  value ? `${doc} Default ${value}.` : doc || type;

function optionsAt(place: MarkupPlace, vocabulary: Vocabulary, xml: boolean): Completion[] {
  if (place.at === 'tag') {
    return vocabulary.all.map((tag) => ({
      label: tagName(tag, xml)!,
      type: 'type',
      info: tag.doc,
      boost: tag.doc.includes('X3DOM') ? 0 : 1,
      apply: applyTag(xml),
    }));
  }
  if (place.at === 'value') {
    const values = vocabulary.attribute(place.tag, place.attribute)?.values ?? [];
    return values.map((label) => ({ label, type: 'constant' }));
  }
  const taken = new Set(place.others.map((name) => name.toLowerCase()));
  return (vocabulary.tag(place.tag)?.attributes ?? [])
    .filter(({ name }) => !taken.has(name.toLowerCase()))
    .map((word) => ({
      label: word.name,
      type: 'property',
      detail: word.type,
      info: docOf(word),
      apply: applyAttribute,
    }));
}

export const completion = (vocabulary: Vocabulary): Extension => {
  function source({ state, pos, explicit }: CompletionContext): CompletionResult | null {
    const place = placeAt(state, pos, -1);
    if (!place) return null;
    const before = state.sliceDoc(Math.max(0, pos - 1), pos);
    if (!explicit && place.at === 'attribute' && !BEFORE_CLOSED.test(before)) return null;
    const options = optionsAt(place, vocabulary, isXml(state.doc.toString()));
    return options.length
      ? { from: Math.min(place.from, pos), options, validFor: /^[\w-]*$/ }
      : null;
  }
  return autocompletion({ override: [source], icons: false });
};

export const hover = (vocabulary: Vocabulary): Extension =>
  hoverTooltip((view, position, side): Tooltip | null => {
    const place = placeAt(view.state, position, side);
    const text = place && textAt(place, vocabulary);
    if (!text) return null;
    const dom = document.createElement('div');
    dom.className = 'field-doc';
    dom.textContent = text;
    return { pos: place.from, end: place.to, create: () => ({ dom }) };
  });

function textAt({ at, tag, attribute }: MarkupPlace, vocabulary: Vocabulary): string | undefined {
  if (at === 'tag') return vocabulary.tag(tag)?.doc;
  const word = vocabulary.attribute(tag, attribute);
  return word && docOf(word);
}
