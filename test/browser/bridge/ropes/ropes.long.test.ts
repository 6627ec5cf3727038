import { expect } from 'chai';
import { claim } from '../../console.js';
import { ropeTags } from '../../../../elements/bridge/index.js';
import type { World } from '../../inside.js';
import { show, until } from '../../scene.js';

// What comes late would have worlds wait for it.
await ropeTags.load();

interface Rope extends Element {
  points: number[][];
  positions: number[][];
  mass: number;
}
interface Attachment extends Element {
  softBody: Element | null;
  body: Element | null;
  index: number;
  position: number[];
}

const BALL = `<x3d-rigid-body id="ball" position="2 5 0" mass="2"><x3d-collidable-shape><shape>
    <sphere radius="0.2"></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`;
/** Two metres, level, fixed at its first point. */
const ROPE =
  '<x3d-rope id="r" points="0 5 0, 2 5 0" segments="8" mass="0.5" fixed-index="0"></x3d-rope>';
const TIE =
  '<x3d-soft-body-attachment id="a" soft-body="r" index="8" body="ball"></x3d-soft-body-attachment>';
const collection = (content: string): string =>
  `<x3d-rigid-body-collection id="c">${content}</x3d-rigid-body-collection>`;

const LINE = `<lineset vertexcount="3"><coordinate point="0 0 0 1 0 0 2 0 0"></coordinate></lineset>`;

/** A scene that stands still. */
async function still(content: string, selector = '#c') {
  const { x3d, world } = await show(content, selector);
  world.paused = true;
  world.reset();
  world.step(0);
  return {
    x3d,
    world,
    rope: x3d.querySelector('#r') as Rope,
    tie: x3d.querySelector('#a') as Attachment,
  };
}

/** What the core has. */
const there = (world: World, name: string, field: string) =>
  world.node(name)!.get(field) as number[];
const points = (world: World): number[][] => there(world, 'r', 'positions') as never;

const near = (actual: number[], expected: number[], off = 1e-6): void => {
  expect(actual.length).to.equal(expected.length);
  actual.forEach((value, i) => expect(value, String(actual)).to.be.closeTo(expected[i]!, off));
};
const distance = (a: number[], b: number[]): number =>
  Math.hypot(...a.map((value, i) => value - b[i]!));

describe('a rope in a page', () => {
  it('holds a ball, to the same bits by both spellings', async () => {
    const hyphened = collection(ROPE + BALL + TIE);
    const plain = hyphened
      .replaceAll('x3d-rope', 'Rope')
      .replaceAll('x3d-soft-body-attachment', 'SoftBodyAttachment');
    const places: number[][][] = [];
    for (const scene of [hyphened, plain]) {
      const { world } = await still(scene);
      world.advance(0.5);
      places.push([there(world, 'ball', 'position'), ...points(world)]);
      expect(world.problems).to.eql([]);
    }
    const [ball, ...rope] = places[0]!;
    near(rope[0]!, [0, 5, 0]);
    expect(distance(ball!, rope[8]!)).to.be.below(1e-4);
    // It swings on two metres of rope.
    expect(distance(ball!, [0, 5, 0])).to.be.closeTo(2, 0.02);
    expect(ball![1]).to.be.below(4.2);
    expect(places[1]).to.eql(places[0]);
  });

  it('is laid along its points where its Transforms are', async () => {
    const { world, rope } = await still(
      `${collection(BALL)}<transform translation="0 1 0" scale="2 2 2"><transform rotation="0 0 1 1.5707963">
         <x3d-rope id="r" points="0 0 0, 1 0 0" segments="2"></x3d-rope></transform></transform>`,
    );
    near(points(world).flat(), [0, 1, 0, 0, 2, 0, 0, 3, 0], 1e-5);
    // In its own frame.
    expect(rope.points).to.eql([
      [0, 0, 0],
      [1, 0, 0],
    ]);
  });

  for (const [where, content] of [
    ['a child', `<x3d-rope id="r">${LINE}</x3d-rope>`],
    ['of a Shape in it', `<x3d-rope id="r"><shape>${LINE}</shape></x3d-rope>`],
    ['of a Shape beside it', `<shape>${LINE}</shape><x3d-rope id="r"></x3d-rope>`],
    [
      'an IndexedLineSet',
      `<x3d-rope id="r"><indexedlineset coordindex="2 1 0 -1 0 1 -1">
         <coordinate point="2 0 0 1 0 0 0 0 0"></coordinate></indexedlineset></x3d-rope>`,
    ],
  ] as const)
    it(`is laid along a LineSet: ${where}`, async () => {
      const { world } = await still(
        `${collection(BALL)}<transform translation="0 3 0">${content}</transform>`,
      );
      near(points(world).flat(), [0, 3, 0, 1, 3, 0, 2, 3, 0]);
      expect(world.problems).to.eql([]);
    });

  it('stands for a Shape elsewhere, and goes on without it', async () => {
    const { x3d, world, rope } = await still(
      `${collection(BALL + '<x3d-rope id="r" for="s"></x3d-rope>')}
       <transform translation="0 3 0"><shape id="s">${LINE}</shape></transform>`,
    );
    near(points(world).flat(), [0, 3, 0, 1, 3, 0, 2, 3, 0]);
    x3d.querySelector('coordinate')!.setAttribute('point', '0 1 0 1 1 0 2 1 0');
    await until(() => points(world)[0]![1] === 4);
    claim('unknown-reference');
    x3d.querySelector('#s')!.remove();
    await until(() => world.node(rope) === undefined);
  });

  it('says what it lacks', async () => {
    claim('bad-value');
    const { x3d, world, rope } = await still(collection('<x3d-rope id="r"></x3d-rope>'));
    expect(world.problems.map(({ code }) => code)).to.eql(['bad-value']);
    rope.append(document.createRange().createContextualFragment(LINE));
    await until(() => world.problems.length === 0);
    expect(x3d.querySelector('x3d-rope')!.matches(':state(problem)')).to.equal(false);
  });

  it('comes late by script, is edited, and goes', async () => {
    const { x3d, world } = await still(collection(BALL));
    const rope = document.createElement('x3d-rope') as unknown as Rope;
    rope.id = 'r';
    rope.points = [
      [0, 5, 0],
      [2, 5, 0],
    ];
    x3d.querySelector('#c')!.append(rope);
    await until(() => world.node(rope) !== undefined);
    world.step(0);
    expect(points(world)).to.eql(rope.points);
    rope.setAttribute('mass', '3');
    world.step(0);
    expect(there(world, 'r', 'mass')).to.equal(3);
    rope.points = [
      [0, 6, 0],
      [0, 4, 0],
      [0, 3, 0],
    ];
    world.step(0);
    expect(points(world).length).to.equal(3);
    world.advance(0.1);
    expect(points(world)[0]![1]).to.be.below(6);
    expect(rope.positions).to.eql(points(world));
    world.reset();
    world.step(0);
    expect(points(world)).to.eql(rope.points);
    rope.remove();
    await until(() => world.node(rope) === undefined);
    expect(world.effects.find(({ name }) => name === 'ropes')!.active).to.equal(false);
  });

  it('stands in an Inline, in the units of its file', async () => {
    const file = `<X3D version="4.0"><head><unit category="length" name="cm" conversionFactor="0.01"/></head>
      <Scene><RigidBodyCollection>
        <Rope DEF="r" fixedIndex="0" radius="2"><LineSet vertexCount="2"><Coordinate point="0 500 0 200 500 0"/></LineSet></Rope>
        <SoftBodyAttachment DEF="a" softBody="r" index="1" position="200 500 0"/>
      </RigidBodyCollection></Scene></X3D>`;
    const url = URL.createObjectURL(new Blob([file], { type: 'model/x3d+xml' }));
    const { world } = await still(
      `<x3d-rigid-body-collection id="c" shared-world="w"></x3d-rigid-body-collection>
       <inline url="${url}" shared-world="w"></inline>`,
    );
    await until(() => world.node('a') !== undefined);
    near(points(world).flat(), [0, 5, 0, 2, 5, 0], 1e-5);
    near([there(world, 'r', 'radius') as never], [0.02], 1e-7);
    world.advance(0.2);
    near(points(world)[1]!, [2, 5, 0], 1e-5);
    expect(world.problems).to.eql([]);
  });

  it('sends its points by ROUTEs: coord_changed', async () => {
    const { x3d, world } = await still(
      `${collection('<x3d-rope def="r" points="0 5 0, 2 5 0" fixed-index="0"></x3d-rope>')}
       <shape><lineset vertexcount="2"><coordinate def="k" point="0 0 0 0 0 0"></coordinate></lineset></shape>
       <ROUTE fromNode="r" fromField="coord_changed" toNode="k" toField="point"></ROUTE>`,
    );
    world.step(12);
    world.paused = false;
    const node = (
      x3d.querySelector('[def=k]') as unknown as {
        _x3domNode: { _vf: { point: { x: number; y: number }[] } };
      }
    )._x3domNode;
    await until(() => node._vf.point[1]!.y < 5 && node._vf.point[0]!.y === 5);
  });
});

describe('an attachment in a page', () => {
  for (const [how, content] of [
    ['attributes', ROPE + BALL + TIE],
    [
      'children',
      `${ROPE}${BALL}<x3d-soft-body-attachment id="a" index="8"><x3d-rope use="r"></x3d-rope>
         <x3d-rigid-body use="ball" containerfield="body"></x3d-rigid-body></x3d-soft-body-attachment>`,
    ],
    [
      'where it stands, before its body is there',
      ROPE.replace(
        '</x3d-rope>',
        '<x3d-soft-body-attachment id="a" index="8" body="ball"></x3d-soft-body-attachment></x3d-rope>',
      ) + BALL,
    ],
  ] as const)
    it(`knows its rope and its body by ${how}`, async () => {
      const { x3d, world, rope, tie } = await still(collection(content));
      expect(tie.softBody).to.equal(rope);
      expect(tie.body).to.equal(x3d.querySelector('#ball'));
      world.advance(0.5);
      expect(distance(points(world)[8]!, there(world, 'ball', 'position'))).to.be.below(1e-4);
      expect(world.problems).to.eql([]);
    });

  it('without a body ties to a place, in the frame in which the rope is laid', async () => {
    const { x3d, world } = await still(
      `${collection(BALL)}<transform translation="0 3 0"><x3d-rope id="r" points="0 0 0, 1 0 0">
         <x3d-soft-body-attachment id="a" index="1" position="1 0 0"></x3d-soft-body-attachment></x3d-rope></transform>`,
    );
    near(there(world, 'a', 'position'), [1, 3, 0]);
    world.advance(0.3);
    near(points(world)[1]!, [1, 3, 0], 1e-5);
    x3d.querySelector('#a')!.setAttribute('position', '1 1 0');
    world.step(0);
    near(there(world, 'a', 'position'), [1, 4, 0]);
  });

  it('follows edits of index, body and position, and lets go when it goes', async () => {
    const { x3d, world, tie } = await still(collection(ROPE + BALL + TIE));
    tie.setAttribute('index', '4');
    world.advance(0.5);
    const off = (i: number): number =>
      distance(points(world)[i]!, there(world, 'ball', 'position'));
    expect(off(4)).to.be.below(1e-4);
    tie.setAttribute('position', '0 0.2 0');
    world.advance(0.5);
    expect(off(4)).to.be.closeTo(0.2, 1e-3);
    claim('unknown-reference');
    tie.setAttribute('body', 'other');
    world.step(0);
    expect(world.node(tie)).to.equal(undefined);
    expect(world.problems.map(({ code }) => code)).to.eql(['unknown-reference']);
    tie.body = x3d.querySelector('#ball');
    world.step(0);
    expect(tie.body).to.equal(x3d.querySelector('#ball'));
    expect(world.problems).to.eql([]);
    tie.remove();
    await until(() => world.node(tie) === undefined);
    world.advance(1);
    expect(off(4)).to.be.above(0.5);
  });

  it('says so where its body is in another world than its rope', async () => {
    claim('unknown-reference');
    const { x3d, world, tie } = await still(collection(ROPE + TIE) + BALL);
    expect(world.node(tie)).to.equal(undefined);
    expect(world.problems.map(({ message }) => message).join()).to.match(/in another world/);
    x3d.querySelector('#c')!.append(x3d.querySelector('#ball')!);
    await until(() => world.node(tie) !== undefined);
    expect(world.problems).to.eql([]);
  });

  it('waits while its rope is not there', async () => {
    const { x3d, world, rope, tie } = await still(collection(ROPE + BALL + TIE));
    claim('unknown-reference');
    rope.remove();
    await until(() => world.node(tie) === undefined);
    x3d.querySelector('#c')!.prepend(rope);
    await until(() => world.node(tie) !== undefined);
    expect(tie.softBody).to.equal(rope);
    expect(world.problems).to.eql([]);
  });
});
