import assert from 'node:assert/strict';
import { test } from 'node:test';
import { markupIn, playgroundAddress, sharedHash } from '../../../site/playground/address.js';
import { changesBetween, type Change } from '../../../site/playground/text/changes.js';
import { inOrder } from '../../../site/playground/text/in-order.js';
import { isXml, parse } from '../../../site/playground/text/parse.js';
import { print } from '../../../site/playground/text/print.js';
import { isElement, type TreeNode } from '../../../site/playground/text/tree.js';
import { whole } from '../../../site/playground/text/whole.js';

const tree = (text: string): TreeNode[] => {
  const { roots, fault } = parse(text);
  assert.equal(fault, undefined);
  return roots!;
};

const named = (node: TreeNode): string =>
  isElement(node) ? (node.attributes.get('id')?.value ?? node.tag) : node.text;

/** What is done, in words. */
const inWords = (change: Change): string =>
  change.do === 'set'
    ? `set ${named(change.element)} ${change.name}=${change.value}`
    : `${change.do} ${named(change.node)}`;

const between = (last: string, next: string): string[] =>
  changesBetween(tree(last), tree(next)).changes.map(inWords);

const body = (id: string, mass = 1) =>
  `<transform id="${id}"><x3d-rigid-body mass="${mass}"></x3d-rigid-body></transform>`;
const plain = (x: number) => `<transform translation="${x} 0 0"><box></box></transform>`;

test('another value is one edit of one attribute', () => {
  assert.deepEqual(between(`<scene>${body('a', 2)}</scene>`, `<scene>${body('a', 3)}</scene>`), [
    'set x3d-rigid-body mass=3',
  ]);
});

test('spaces, comments, quotes and the case of a name are no edit', () => {
  const next =
    '<scene >\n<!-- fixed --><x3d-rigid-body  MASS=\'2\' fixed=""></x3d-rigid-body></scene>';
  assert.deepEqual(
    between('<scene><x3d-rigid-body mass="2" fixed></x3d-rigid-body></scene>', next),
    [],
  );
});

test('an attribute that goes is taken away, one that comes is set', () => {
  assert.deepEqual(between('<box size="1 1 1"></box>', '<box solid="false"></box>'), [
    'set box size=null',
    'set box solid=false',
  ]);
});

test('an element that comes among equal ones is the only change', () => {
  assert.deepEqual(between(plain(1) + plain(1), plain(1) + body('new') + plain(1)), ['place new']);
  assert.deepEqual(between(plain(1) + plain(2), plain(0) + plain(1) + plain(2)), [
    'place transform',
  ]);
});

test('an element that goes is the only change', () => {
  assert.deepEqual(between(body('a') + body('b') + body('c'), body('a') + body('c')), ['remove b']);
});

test('of elements in another order the fewest are moved', () => {
  const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((id) => body(id));
  assert.deepEqual(between(`${a}${b}${c}${d}`, `${d}${a}${b}${c}`), ['place d']);
  assert.deepEqual(between(`${a}${b}${c}`, `${b}${c}${a}`), ['place a']);
});

test('another name is an edit of the name', () => {
  assert.deepEqual(between(body('a') + body('b'), body('a') + body('c')), ['set c id=c']);
});

test('an element that is moved and edited at once is still the same', () => {
  assert.deepEqual(between(body('a', 1) + body('b', 1), body('b', 5) + body('a', 1)), [
    'place a',
    'set x3d-rigid-body mass=5',
  ]);
});

test('another tag is another element', () => {
  assert.deepEqual(between('<box></box>', '<sphere></sphere>'), ['remove box', 'place sphere']);
});

test('words are written anew', () => {
  assert.deepEqual(between('<p>one</p>', '<p>two</p>'), ['write two']);
});

test('a longest row that rises', () => {
  assert.deepEqual(inOrder([]), []);
  assert.deepEqual(inOrder([3, 0, 1, 2]), [1, 2, 3]);
  assert.deepEqual(inOrder([0, 1, 2]), [0, 1, 2]);
});

for (const [text, message] of [
  ['<transform', 'This tag is not finished.'],
  [
    '<transform><x3d-rigid-body mass="2></x3d-rigid-body></transform>',
    /quotes|not finished|not closed/,
  ],
  ['<transform translation=></transform>', /value in quotes/],
  ['<transform><box></transform>', '<box> is not closed.'],
  ['<scene></transform></scene>', '</transform> closes nothing that is open here.'],
  ['<scene><</scene>', 'Here a tag begins that has no name yet.'],
  ['<box size="1 1 1"/>', /can't close itself: write <box><\/box>/],
  ['<Scene><Box size="1 1 1"/><Shape></Scene>', '<Shape> is not closed.'],
  ['<Scene><Box size/></Scene>', /value in quotes/],
] as const) {
  test(`${text} is not well-formed, and is told why`, () => {
    const { fault } = parse(text);
    assert.match(
      fault!.message,
      message instanceof RegExp ? message : new RegExp(escaped(message)),
    );
  });
}

const escaped = (text: string) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&');

test('text is XML where it begins as XML or has a tag in the case of X3D that closes itself', () => {
  assert.ok(isXml('<?xml version="1.0"?><X3D></X3D>'));
  assert.ok(isXml('<!DOCTYPE X3D PUBLIC "x"><X3D></X3D>'));
  assert.ok(isXml('<Transform><RigidBody mass="2"/></Transform>'));
  assert.ok(!isXml('<transform><RigidBody mass="2"></RigidBody></transform>'));
  assert.ok(!isXml('<transform><!-- not <Box/> --></transform>'));
  assert.ok(!isXml('<transform></transform><script>const text = "<Box/>";</script>'));
});

test('both spellings make the same elements', () => {
  assert.deepEqual(
    between('<Scene><Box size="1 1 1"/></Scene>', '<scene><box size="1 1 1"></box></scene>'),
    [],
  );
});

test('a part knows where it stands', () => {
  const text = '<scene>\n  <box size="1 1 1"></box>\n</scene>';
  const [scene] = tree(text);
  assert.ok(isElement(scene!) && isElement(scene.children[0]!));
  const { from, to } = scene.children[0].attributes.get('size')!;
  assert.equal(text.slice(from, to), 'size="1 1 1"');
});

test('a space between two elements counts among words, and nowhere else', () => {
  const [p, scene] = tree('<p> <b>1</b> <b>2</b> </p><scene> <box></box> <box></box> </scene>');
  const texts = (node: TreeNode) => isElement(node) && node.children.map(named);
  assert.deepEqual(texts(p!), ['b', ' ', 'b', ' ']);
  assert.deepEqual(texts(scene!), ['box', 'box']);
});

test('a script is printed as it is', () => {
  const text = '<script>\n  if (1 < 2 && "a") run();\n</script>';
  assert.equal(print(tree(text)), text);
});

test('what is missing around a scene is put there', () => {
  assert.match(
    print(whole(tree('<box></box>'))),
    /^<x3d>\n {2}<scene>[^]*<viewpoint[^]*<box><\/box>/,
  );
  assert.equal(print(whole(tree('<scene></scene>'))), '<x3d>\n  <scene></scene>\n</x3d>');
  assert.equal(print(whole(tree('<x3d></x3d>'))), '<x3d></x3d>');
});

test('a tree is printed as HTML that reads as the same tree', () => {
  const text = `<Scene><Text string='"a" "b &lt; c"'/><Box/></Scene>`;
  const printed = print(tree(text));
  assert.ok(!isXml(printed));
  assert.deepEqual(between(text, printed), []);
});

const TEXTS = ['<scene></scene>', '', '<!-- Ä 漢 🙂 -->\n'.repeat(500)];

test('an address holds the whole text, as it is and compressed', async () => {
  for (const text of TEXTS) {
    const { hash } = new URL(playgroundAddress(text), 'http://site.invalid');
    assert.equal((await markupIn(hash))?.markup, text);
    assert.equal((await markupIn(await sharedHash(text)))?.markup, text);
  }
  assert.ok((await sharedHash(TEXTS[2]!)).length < 300);
});

const EXAMPLES = [
  { id: 'a', markup: '<scene></scene>' },
  { id: 'b', markup: Array.from({ length: 200 }, (_, i) => plain(i)).join('\n') },
];

test('an address of an example is its name, and its edits', async () => {
  const [, b] = EXAMPLES as [(typeof EXAMPLES)[0], (typeof EXAMPLES)[0]];
  assert.equal(await sharedHash(b.markup, b), '#example=b');
  const lines = b.markup.split('\n');
  for (const edited of [
    ['first', ...lines],
    [...lines.slice(0, 5), 'ü', ...lines.slice(6, 150), ...lines.slice(160)],
    [...lines.slice(1, 100), lines[0], ...lines.slice(100)],
  ].map((each) => each.join('\n'))) {
    const hash = await sharedHash(edited, b);
    assert.match(hash, /^#example=b&edits=/);
    assert.ok(hash.length < 150, `${hash.length} letters`);
    assert.deepEqual(await markupIn(hash, EXAMPLES), { markup: edited, example: b });
  }
  assert.match(await sharedHash('<box></box>', b), /^#shared=/);
});

test('edits of an example that has changed since, or that is not there, are refused in words', async () => {
  const [a, b] = EXAMPLES as [(typeof EXAMPLES)[0], (typeof EXAMPLES)[0]];
  const hash = await sharedHash(`${b.markup}\n<box></box>`, b);
  await assert.rejects(markupIn(hash, [a]), /names an example that is not here/);
  await assert.rejects(markupIn(hash, [{ ...b, markup: 'other' }]), /has changed since/);
  await assert.rejects(markupIn(hash.slice(0, -9), EXAMPLES), /cut short/);
});

test('an address without markup holds none; one that was cut short says so', async () => {
  assert.equal(await markupIn(''), undefined);
  assert.equal(await markupIn('#a-heading'), undefined);
  const hash = await sharedHash('<scene></scene>');
  for (const bad of [hash.slice(0, -6), '#shared=%%%', '#shared=', '#markup=_w']) {
    await assert.rejects(markupIn(bad), /holds no markup that can be read/);
  }
});

test('an address that would unfold into gigabytes is refused', async () => {
  const hash = await sharedHash(' '.repeat(5e6));
  await assert.rejects(markupIn(hash), /holds no markup that can be read/);
});
