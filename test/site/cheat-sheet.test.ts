import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { tagOf } from '../../elements/bridge/words/dom.js';
import { eventTypes } from '../../elements/bridge/words/event-types.js';
import { allTypes } from '../../physics-core/all-types.js';
import { additionsOf } from '../../tools/build/manifest-fields.js';

const sheet = readFileSync('site/guide/cheat-sheet.md', 'utf8');

const section = (title: string): string => sheet.split(`\n## ${title}\n`)[1]!.split('\n## ')[0]!;

const named = (text: string): string[] => [...text.matchAll(/`([^`]+)`/g)].map(([, name]) => name!);

/** A row of the table of elements: its tag, and what stands in its other cells. */
const rows = section('Elements')
  .split('\n')
  .flatMap((line) => {
    const [, tag, rest] = /^\| \[`([\w-]+)`\][^|]*\|(.*)\|$/.exec(line) ?? [];
    return tag ? [{ tag, names: named(rest!) }] : [];
  });

const camel = (name: string): string =>
  name.replaceAll(/-(.)/g, (_, letter) => letter.toUpperCase());

test('the cheat-sheet has each node of the component, once', () => {
  assert.deepEqual(rows.map(({ tag }) => tag).sort(), Object.values(allTypes).map(tagOf).sort());
});

test('each field that the cheat-sheet names is one of its node', () => {
  for (const type of Object.values(allTypes)) {
    const { names } = rows.find(({ tag }) => tag === tagOf(type))!;
    const known = [
      ...Object.keys(type.fields),
      ...additionsOf(type).map(({ attribute }) => camel(attribute)),
    ];
    const unknown = names.filter((name) => /^[\w-]+$/.test(name) && !known.includes(camel(name)));
    // The property that leads to the world, and the sensor's list, are no fields of these nodes.
    assert.deepEqual(
      unknown.filter((name) => name !== 'contacts' || type.name !== 'Contact'),
      [],
      type.name,
    );
  }
});

test('the cheat-sheet has all events', () => {
  const there = named(section('Events'));
  assert.deepEqual(
    Object.keys(eventTypes).filter((name) => !there.includes(name)),
    [],
  );
});
