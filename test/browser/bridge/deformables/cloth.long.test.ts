import { expect } from 'chai';
import { claim } from '../../console.js';
import { deformableTags, ropeTags } from '../../../../elements/bridge/index.js';
import type { World } from '../../inside.js';
import { show, until } from '../../scene.js';

// What comes late would have worlds wait for it.
await Promise.all([deformableTags.load(), ropeTags.load()]);

interface Cloth extends Element {
  size: number[];
  subdivision: number[];
  positions: number[][];
  mass: number;
  fixedIndex: number[];
}
interface Attachment extends Element {
  softBody: Element | null;
  body: Element | null;
}

const BALL = `<x3d-rigid-body id="ball" position="1 -1 0" mass="0.2"><x3d-collidable-shape><shape>
    <sphere radius="0.1"></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`;
/** Two metres square, upright, fixed along its upper edge. */
const SHEET = `<x3d-cloth id="r" size="2 2" subdivision="4 4" mass="0.5" fixedIndex="20 21 22 23 24"></x3d-cloth>`;
const TIE = `<x3d-soft-body-attachment id="a" softBody="r" index="4" body="ball"></x3d-soft-body-attachment>`;
const collection = (content: string): string =>
  `<x3d-rigid-body-collection id="c">${content}</x3d-rigid-body-collection>`;

/** A unit square of two triangles, at its own origin. */
const TRIANGLES = `<indexedtriangleset index="0 1 2 0 2 3"><coordinate point="0 0 0 1 0 0 1 1 0 0 1 0"></coordinate></indexedtriangleset>`;
const SQUARE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];

/** A scene that stands still. */
async function still(content: string, selector = '#c') {
  const { x3d, world } = await show(content, selector);
  world.paused = true;
  world.reset();
  world.step(0);
  return {
    x3d,
    world,
    cloth: x3d.querySelector('#r') as Cloth,
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

describe('a cloth in a page', () => {
  it('hangs, and holds a ball, to the same bits by both spellings', async () => {
    const hyphened = collection(SHEET + BALL + TIE);
    const plain = hyphened
      .replaceAll('x3d-cloth', 'Cloth')
      .replaceAll('x3d-soft-body-attachment', 'SoftBodyAttachment');
    const places: number[][][] = [];
    for (const scene of [hyphened, plain]) {
      const { world } = await still(scene);
      expect(points(world).length).to.equal(25);
      world.advance(0.5);
      places.push([there(world, 'ball', 'position'), ...points(world)]);
      expect(world.problems).to.eql([]);
    }
    const [ball, ...cloth] = places[0]!;
    near(cloth[20]!, [-1, 1, 0]);
    expect(distance(ball!, cloth[4]!)).to.be.below(1e-3);
    expect(places[1]).to.eql(places[0]);
  });

  it('is a sheet in the plane of its Transform, as long as that makes it', async () => {
    const { world, cloth } = await still(
      `${collection(BALL)}<transform translation="0 1 0" scale="2 2 2"><transform rotation="1 0 0 1.5707963267948966">
         <x3d-cloth id="r" size="1 1" subdivision="1 1"></x3d-cloth></transform></transform>`,
    );
    near(points(world).flat(), [-1, 1, -1, 1, 1, -1, -1, 1, 1, 1, 1, 1], 1e-6);
    // In its own frame.
    expect(cloth.size).to.eql([1, 1]);
    cloth.size = [2, 1];
    await until(() => Math.abs(points(world)[0]![0]! + 2) < 1e-6);
    cloth.setAttribute('subdivision', '2 2');
    await until(() => points(world).length === 9);
  });

  for (const [where, content] of [
    ['a child', `<x3d-cloth id="r">${TRIANGLES}</x3d-cloth>`],
    ['of a Shape in it', `<x3d-cloth id="r"><shape>${TRIANGLES}</shape></x3d-cloth>`],
    ['of a Shape beside it', `<shape>${TRIANGLES}</shape><x3d-cloth id="r"></x3d-cloth>`],
    [
      'an IndexedFaceSet',
      `<Cloth id="r"><IndexedFaceSet coordIndex="0 1 2 3 -1"><Coordinate point="0 0 0 1 0 0 1 1 0 0 1 0"></Coordinate></IndexedFaceSet></Cloth>`,
    ],
  ] as const)
    it(`is laid as a geometry says: ${where}`, async () => {
      const { world } = await still(
        `${collection(BALL)}<transform translation="0 3 0" scale="1 2 1">${content}</transform>`,
      );
      near(
        points(world).flat(),
        SQUARE.map((value, i) => (i % 3 === 1 ? 3 + 2 * value : value)),
      );
      expect(world.problems).to.eql([]);
    });

  it('is laid as an X3DOM Plane lies: with its cells, else with those that the cloth says', async () => {
    const plane = (more: string): string => `${collection(BALL)}<transform translation="0 3 0">
      <shape><appearance></appearance><plane size="1 1" ${more}></plane></shape>
      <x3d-cloth id="r" subdivision="3 3"></x3d-cloth></transform>`;
    const { world } = await still(plane('subdivision="2 1" center="0.5 0.5 0"'));
    near(points(world).slice(0, 4).flat(), [0, 3, 0, 0.5, 3, 0, 1, 3, 0, 0, 4, 0]);
    expect(points(world).length).to.equal(6);
    const other = await still(plane(''));
    expect(points(other.world).length).to.equal(16);
    near(points(other.world)[0]!, [-0.5, 2.5, 0]);
  });

  it('stands for a Shape elsewhere, and goes on without it', async () => {
    const { x3d, world, cloth } = await still(
      `${collection(BALL + '<x3d-cloth id="r" for="s"></x3d-cloth>')}
       <transform translation="0 3 0"><shape id="s">${TRIANGLES}</shape></transform>`,
    );
    near(points(world)[0]!, [0, 3, 0]);
    x3d.querySelector('coordinate')!.setAttribute('point', '0 1 0 1 1 0 1 2 0 0 2 0');
    await until(() => points(world)[0]![1] === 4);
    claim('unknown-reference');
    x3d.querySelector('#s')!.remove();
    await until(() => world.node(cloth) === undefined);
  });

  it('takes its Shape, with which nothing else collides, and leaves that of a body to it', async () => {
    const { world } = await still(
      `<transform translation="0 3 0">
         <x3d-cloth id="r" size="2 2" subdivision="2 2"></x3d-cloth>
         <shape id="s"><box></box></shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>`,
      '#b',
    );
    expect(points(world).length).to.equal(9);
    expect(world.raycast([0, 3, 5], [0, 3, -5])?.node).to.equal(world.node('b'));
  });

  it('says what it lacks', async () => {
    claim('bad-value');
    const { x3d, world, cloth } = await still(collection('<x3d-cloth id="r"></x3d-cloth>'));
    expect(world.problems.map(({ code }) => code)).to.eql(['bad-value']);
    cloth.append(document.createRange().createContextualFragment(TRIANGLES));
    await until(() => world.problems.length === 0);
    expect(x3d.querySelector('x3d-cloth')!.matches(':state(problem)')).to.equal(false);
  });

  it('comes late by script, is edited, and goes', async () => {
    const { x3d, world } = await still(collection(BALL));
    const cloth = document.createElement('x3d-cloth') as unknown as Cloth;
    cloth.id = 'r';
    cloth.size = [1, 1];
    cloth.subdivision = [1, 1];
    x3d.querySelector('#c')!.append(cloth);
    await until(() => world.node(cloth) !== undefined);
    world.step(0);
    near(points(world).flat(), [-0.5, -0.5, 0, 0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0.5, 0]);
    cloth.setAttribute('mass', '3');
    cloth.fixedIndex = [2, 3];
    world.step(0);
    expect(there(world, 'r', 'mass')).to.equal(3);
    world.advance(0.1);
    near(points(world)[2]!, [-0.5, 0.5, 0]);
    cloth.removeAttribute('mass');
    cloth.subdivision = [2, 1];
    world.step(0);
    expect(there(world, 'r', 'mass')).to.equal(1);
    expect(points(world).length).to.equal(6);
    expect(cloth.positions).to.eql(points(world));
    cloth.remove();
    await until(() => world.node(cloth) === undefined);
    expect(world.effects.find(({ name }) => name === 'deformables')!.active).to.equal(false);
  });

  it('stands in an Inline, in the units of its file', async () => {
    const file = `<X3D version="4.0"><head><unit category="length" name="cm" conversionFactor="0.01"/></head>
      <Scene><Transform translation="0 100 0">
        <Cloth DEF="r" size="200 100" subdivision="1 1" thickness="2">
          <SoftBodyAttachment DEF="a" index="0" position="-100 -50 0"/></Cloth>
      </Transform><RigidBodyCollection/></Scene></X3D>`;
    const url = URL.createObjectURL(new Blob([file], { type: 'model/x3d+xml' }));
    const { world } = await still(
      `<x3d-rigid-body-collection id="c" shared-world="w"></x3d-rigid-body-collection>
       <inline url="${url}" shared-world="w"></inline>`,
    );
    await until(() => world.node('a') !== undefined);
    near(points(world).flat(), [-1, 0.5, 0, 1, 0.5, 0, -1, 1.5, 0, 1, 1.5, 0], 1e-6);
    near([there(world, 'r', 'thickness') as never], [0.02], 1e-7);
    near(there(world, 'a', 'position'), [-1, 0.5, 0], 1e-6);
    expect(world.problems).to.eql([]);
  });

  it('sends its points by ROUTEs: coord_changed', async () => {
    const { x3d, world } = await still(
      `${collection('<x3d-cloth def="r" size="1 1" subdivision="1 1"></x3d-cloth>')}
       <shape><pointset><coordinate def="k" point="0 0 0 0 0 0 0 0 0 0 0 0"></coordinate></pointset></shape>
       <ROUTE fromNode="r" fromField="coord_changed" toNode="k" toField="point"></ROUTE>`,
    );
    world.step(12);
    world.paused = false;
    const node = (
      x3d.querySelector('[def=k]') as unknown as {
        _x3domNode: { _vf: { point: { x: number; y: number }[] } };
      }
    )._x3domNode;
    await until(() => node._vf.point[0]!.y < -0.5 && node._vf.point[0]!.x === -0.5);
  });
});

describe('an attachment of a cloth in a page', () => {
  for (const [how, content] of [
    ['attributes', SHEET + BALL + TIE],
    [
      'children',
      `${SHEET}${BALL}<x3d-soft-body-attachment id="a" index="4"><x3d-cloth use="r"></x3d-cloth>
         <x3d-rigid-body use="ball" containerfield="body"></x3d-rigid-body></x3d-soft-body-attachment>`,
    ],
    [
      'where it stands, before its body is there',
      SHEET.replace(
        '</x3d-cloth>',
        '<x3d-soft-body-attachment id="a" index="4" body="ball"></x3d-soft-body-attachment></x3d-cloth>',
      ) + BALL,
    ],
  ] as const)
    it(`knows what it ties, and its body, by ${how}`, async () => {
      const { x3d, world, cloth, tie } = await still(collection(content));
      expect(tie.softBody).to.equal(cloth);
      expect(tie.body).to.equal(x3d.querySelector('#ball'));
      world.advance(0.5);
      expect(distance(points(world)[4]!, there(world, 'ball', 'position'))).to.be.below(4e-3);
      expect(world.problems).to.eql([]);
    });

  it('without a body ties to a place, in the frame in which the cloth is laid', async () => {
    const { x3d, world } = await still(
      `${collection(BALL)}<transform translation="0 3 0"><x3d-cloth id="r" size="2 2" subdivision="2 2">
         <x3d-soft-body-attachment id="a" index="8" position="1 1 0"></x3d-soft-body-attachment></x3d-cloth></transform>`,
    );
    near(there(world, 'a', 'position'), [1, 4, 0]);
    world.advance(0.3);
    near(points(world)[8]!, [1, 4, 0], 1e-5);
    x3d.querySelector('#a')!.setAttribute('position', '1 0 0');
    world.step(0);
    near(there(world, 'a', 'position'), [1, 3, 0]);
  });

  it('may name a rope and then a cloth', async () => {
    const { x3d, world, cloth, tie } = await still(
      collection(`${SHEET}<x3d-rope id="l" points="1 -1 0 1 -0.5 0"></x3d-rope>${BALL}${TIE}`),
    );
    const tied = (): unknown => world.node('a')!.get('softBody');
    tie.softBody = x3d.querySelector('#l');
    tie.setAttribute('index', '0');
    world.step(0);
    expect(tied()).to.equal(world.node('l'));
    tie.softBody = cloth;
    tie.setAttribute('index', '4');
    world.step(0);
    expect(tied()).to.equal(world.node('r'));
    expect(world.problems).to.eql([]);
  });

  it('waits while its cloth is not there', async () => {
    const { x3d, world, cloth, tie } = await still(collection(SHEET + BALL + TIE));
    claim('unknown-reference');
    cloth.remove();
    await until(() => world.node(tie) === undefined);
    x3d.querySelector('#c')!.prepend(cloth);
    await until(() => world.node(tie) !== undefined);
    expect(tie.softBody).to.equal(cloth);
    expect(world.problems).to.eql([]);
  });
});
