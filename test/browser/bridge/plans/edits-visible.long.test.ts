import { expect } from 'chai';
import { worldOf } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { drawn, drawnAt, nextFrame, show, until } from '../../scene.js';

interface Body {
  pointer: number;
  get(field: string): number[];
}

type World = Awaited<ReturnType<typeof show>>['world'];

const bodyOf = (world: World, name: string) => world.node(name) as unknown as Body;

/** A body seen from above through its shape: how high its top lies over the place `x`. */
const topAt = (world: World, x = 0): number =>
  world.raycast([x, 100, 0], [x, -100, 0])?.position[1] ?? NaN;

/** A box of 1 m that flies, under two Transforms, and a ball beside it, at work for a quarter of a second. */
const flying = (attributes = '', geometry = '<box id="g" size="1 1 1"></box>') => `
  <x3d-rigid-body-collection default gravity="0 0 0"></x3d-rigid-body-collection>
  <transform id="outer"><transform id="t" ${attributes}><shape id="s">${geometry}</shape>
    <x3d-rigid-body id="body" linearVelocity="0 2 0"></x3d-rigid-body></transform></transform>
  <transform id="elsewhere"></transform>
  <transform translation="9 0 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball" linearVelocity="0 1 0"></x3d-rigid-body></transform>`;

async function begin(markup: string) {
  const { x3d, world } = await show(markup, '#body');
  world.paused = true;
  world.reset();
  world.advance(0.25);
  await drawn();
  const ball = bodyOf(world, 'ball').get('position');
  const { created, destroyed } = world.stats;
  const { pointer } = bodyOf(world, 'body');
  const element = (selector: string): Element => x3d.querySelector(selector)!;
  /** Nothing was made but what must be, nobody else was touched, and the body goes on as it went. */
  const check = (position: number[], made = 0): void => {
    const body = bodyOf(world, 'body');
    world.step(0);
    for (const [i, value] of position.entries())
      expect(body.get('position')[i], 'position').to.be.closeTo(value, 1e-5);
    expect(body.get('linearVelocity')).to.eql([0, 2, 0]);
    expect(body.pointer, 'the Bullet object').to.equal(pointer);
    expect(bodyOf(world, 'ball').get('position')).to.eql(ball);
    expect([world.stats.created - created, world.stats.destroyed - destroyed]).to.eql([made, made]);
  };
  return { x3d, world, element, check };
}

type Test = (scene: Awaited<ReturnType<typeof begin>>) => void | Promise<void>;

/** One test in both spellings. */
function both(says: string, test: Test, attributes = '', geometry?: string): void {
  for (const [spelling, markup] of bothSpellings(flying(attributes, geometry)))
    it(`${says} (${spelling} tags)`, async () => {
      const scene = await begin(markup);
      await test(scene);
    });
}

interface X3DElement extends Element {
  setFieldValue(name: string, value: unknown): void;
}
declare const x3dom: {
  fields: { SFVec3f: new (x: number, y: number, z: number) => unknown };
};

/** By X3D's own way to write to an element. */
const moveTo = (element: Element, x: number, y: number, z: number): void =>
  (element as X3DElement).setFieldValue('translation', new x3dom.fields.SFVec3f(x, y, z));

describe('an edit of what is seen', () => {
  both(
    'moves the body with its Transform, by attribute and by X3D event',
    async ({ element, check }) => {
      check([0, 0.5, 0]);
      element('#t').setAttribute('translation', '1 2 3');
      check([1, 2, 3]);
      moveTo(element('#t'), 3, 2, 1);
      check([3, 2, 1]);
      element('#outer').setAttribute('translation', '0 5 0');
      check([3, 7, 1]);
      element('#t').removeAttribute('translation');
      check([0, 5, 0]);
      await drawn();
      expect(drawnAt(element('#t'))).to.eql([0, 5, 0]);
    },
  );

  both('turns the body with its Transform', ({ world, element, check }) => {
    element('#t').setAttribute('rotation', '0 0 1 0.7853981633974483');
    check([0, 0.5, 0]);
    expect(topAt(world)).to.be.closeTo(0.5 + Math.SQRT1_2, 1e-3);
    element('#t').removeAttribute('rotation');
    check([0, 0.5, 0]);
    expect(topAt(world)).to.be.closeTo(1, 1e-3);
  });

  both('scales the shape, its own and those above', ({ world, element, check }) => {
    element('#t').setAttribute('scale', '1 3 1');
    expect(topAt(world)).to.be.closeTo(0.5 + 1.5, 1e-3);
    element('#outer').setAttribute('scale', '2 2 2');
    check([0, 1, 0]);
    expect(topAt(world)).to.be.closeTo(1 + 3, 1e-3);
    element('#t').removeAttribute('scale');
    expect(topAt(world)).to.be.closeTo(1 + 1, 1e-3);
    element('#outer').removeAttribute('scale');
    expect(topAt(world)).to.be.closeTo(0.5 + 0.5, 1e-3);
  });

  both('reshapes the body with the size of its geometry', ({ world, element, check }) => {
    element('#g').setAttribute('size', '1 3 1');
    expect(topAt(world)).to.be.closeTo(0.5 + 1.5, 1e-3);
    check([0, 0.5, 0]);
    // X3D's box is 2 m.
    element('#g').removeAttribute('size');
    expect(topAt(world)).to.be.closeTo(0.5 + 1, 1e-3);
    check([0, 0.5, 0]);
  });

  const TETRAHEDRON = '0 0 0, 1 0 0, 0 1 0, 0 0 1';
  both(
    'reshapes the body with the points and faces of its geometry',
    ({ world, element, check }) => {
      expect(topAt(world, 0.01)).to.be.closeTo(0.5 + 0.99, 0.03);
      element('#points').setAttribute('point', TETRAHEDRON.replace('0 1 0', '0 3 0'));
      expect(topAt(world, 0.01)).to.be.closeTo(0.5 + 2.97, 0.05);
      check([0, 0.5, 0]);
      claim('[concave-dynamic]');
      element('#g').setAttribute('coordIndex', '0 1 2 -1');
      expect(topAt(world, 0.01)).to.be.closeTo(0.5 + 2.97, 0.05);
      check([0, 0.5, 0]);
    },
    '',
    `<indexedfaceset id="g" coordIndex="0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1"><coordinate id="points" point="${TETRAHEDRON}"></coordinate></indexedfaceset>`,
  );

  both(
    'gives the body another shape with another geometry, another Shape, none, and one again',
    ({ world, element, check }) => {
      const shape = element('#s');
      element('#g').outerHTML = '<sphere id="g" radius="3"></sphere>';
      expect(topAt(world)).to.be.closeTo(0.5 + 3, 1e-3);
      check([0, 0.5, 0]);
      shape.outerHTML = '<shape id="s"><box size="1 5 1"></box></shape>';
      expect(topAt(world)).to.be.closeTo(0.5 + 2.5, 1e-3);
      check([0, 0.5, 0]);
      claim('has no Shape that could collide');
      element('#s').remove();
      expect(topAt(world)).to.eql(NaN);
      check([0, 0.5, 0]);
      element('#t').insertAdjacentHTML(
        'afterbegin',
        '<shape id="s"><box size="1 1 1"></box></shape>',
      );
      expect(topAt(world)).to.be.closeTo(0.5 + 0.5, 1e-3);
      check([0, 0.5, 0]);
    },
  );

  both(
    'keeps the world pose of a body whose Transform comes under another, and takes its scale',
    async ({ world, element, check }) => {
      element('#elsewhere').setAttribute('translation', '0 -3 0');
      element('#elsewhere').setAttribute('scale', '1 2 1');
      element('#elsewhere').append(element('#t'));
      check([0, 0.5, 0]);
      expect(topAt(world)).to.be.closeTo(0.5 + 1, 1e-3);
      await until(() => Math.abs(drawnAt(element('#t'))[1]! - 0.5) < 1e-5);
    },
  );

  both('that only hides it changes nothing', ({ element, world, check }) => {
    const { patched } = world.stats;
    for (const selector of ['#t', '#s']) element(selector).setAttribute('render', 'false');
    for (const selector of ['#t', '#s']) element(selector).setAttribute('visible', 'false');
    check([0, 0.5, 0]);
    expect(topAt(world)).to.be.closeTo(1, 1e-3);
    expect(world.stats.patched).to.equal(patched);
  });

  both('wins over what the simulation draws at the same time', async ({ x3d, world, element }) => {
    world.paused = false;
    for (let i = 1; i <= 5; i++) {
      await nextFrame();
      element('#t').setAttribute('translation', `${i} 50 0`);
      await nextFrame();
      await nextFrame();
      const [x, y] = bodyOf(world, 'body').get('position');
      expect(x).to.equal(i);
      expect(y).to.be.within(50, 52);
    }
    world.paused = true;
    await drawn();
    expect(drawnAt(x3d.querySelector('#t')!)[0]).to.equal(5);
  });

  both('is not what the simulation draws: nothing comes back', async ({ x3d, world, element }) => {
    const markup = (x3d.querySelector('scene') as Element).outerHTML;
    const { patched, created } = world.stats;
    world.paused = false;
    const from = world.time;
    await until(() => world.time > from + 0.3);
    world.paused = true;
    await drawn();
    // 2 m/s from 0.25 s on, never thrown back.
    const [, y] = bodyOf(world, 'body').get('position');
    expect(y).to.be.closeTo(2 * world.time, 1e-3);
    expect(drawnAt(element('#t'))[1]).to.be.closeTo(y!, 1e-4);
    expect(world.stats).to.include({ patched, created });
    expect((x3d.querySelector('scene') as Element).outerHTML).to.equal(markup);
  });
});

describe('a scale above a shape that stands in the scene and belongs to a body elsewhere', () => {
  const owned = (offset: boolean): string => {
    const shape = (id: string): string =>
      `<x3d-collidable-shape def="${id}"><shape><box size="1 1 1"></box></shape></x3d-collidable-shape>`;
    const placed = offset
      ? `<x3d-collidable-offset def="c" translation="0 2 0">${shape('inner')}</x3d-collidable-offset>`
      : shape('c');
    const use = offset ? 'x3d-collidable-offset' : 'x3d-collidable-shape';
    return `<transform id="above">${placed}</transform>
      <x3d-rigid-body-collection gravity="0 0 0"><x3d-rigid-body id="body" position="0 1 0"><${use} use="c"></${use}></x3d-rigid-body></x3d-rigid-body-collection>`;
  };
  for (const [what, offset] of [
    ['a CollidableShape', false],
    ['one in a CollidableOffset', true],
  ] as const)
    for (const [spelling, markup] of bothSpellings(owned(offset)))
      it(`is read again when it is edited: ${what} (${spelling} tags)`, async () => {
        const { x3d, world } = await show(markup, '#body');
        world.paused = true;
        world.step(1);
        const body = bodyOf(world, 'body');
        const { pointer } = body;
        const base = offset ? 3 : 1;
        expect(topAt(world)).to.be.closeTo(base + 0.5, 1e-3);
        x3d.querySelector('#above')!.setAttribute('scale', '1 4 1');
        world.step(0);
        expect(topAt(world)).to.be.closeTo(base + 2, 1e-3);
        x3d.querySelector('#above')!.removeAttribute('scale');
        world.step(0);
        expect(topAt(world)).to.be.closeTo(base + 0.5, 1e-3);
        expect(body.pointer).to.equal(pointer);
        expect(worldOf(x3d.querySelector('#body')!)).to.equal(world);
      });
});
