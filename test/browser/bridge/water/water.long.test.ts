import { expect } from 'chai';
import { claim } from '../../console.js';
import { waterTags } from '../../../../elements/bridge/index.js';
import { worldOf, type World } from '../../inside.js';
import { place, position, show, until } from '../../scene.js';

// What comes late would have worlds wait for it.
await waterTags.load();

interface Water extends Element {
  position: number[];
  size: number[];
  density: number;
}

/** Half as heavy as water. */
const BOX = `<transform translation="0 0.3 0">
    <shape><box size="1 1 1"></box></shape><x3d-rigid-body id="raft" mass="500"></x3d-rigid-body>
  </transform>`;
const SHAPE = '<shape id="s"><appearance></appearance><box size="10 4 10"></box></shape>';
const WATER = '<x3d-water-volume id="w"></x3d-water-volume>';
/** Its surface is at y = 0. */
const POOL = `<transform id="pool" translation="0 -2 0">${SHAPE}${WATER}</transform>`;

/** A scene that stands still, and its water. */
async function still(content: string, selector = '#raft') {
  const { x3d, world } = await show(content, selector);
  world.paused = true;
  world.step(0);
  return { x3d, world, water: x3d.querySelector('#w') as Water };
}

/** What the core has of the water. */
const there = (world: World, name: string): number[] => world.node('w')!.get(name) as number[];

const near = (actual: number[], expected: number[], off = 1e-6): void => {
  expect(actual.length).to.equal(expected.length);
  actual.forEach((value, i) => expect(value, String(actual)).to.be.closeTo(expected[i]!, off));
};

describe('water in a page', () => {
  it('a box floats in it, to the same bits by both spellings', async () => {
    const plain = POOL.replaceAll('x3d-water-volume', 'WaterVolume');
    const places: number[][] = [];
    for (const pool of [POOL, plain]) {
      const { world } = await still(BOX + pool);
      world.reset();
      world.advance(20);
      places.push(position(world, 'raft'));
      expect(world.problems).to.eql([]);
    }
    near(places[0]!, [0, 0, 0], 1e-3);
    expect(places[1]).to.eql(places[0]);
  });

  it('is where its Transform is, and as large as the Box of the Shape beside it', async () => {
    const { world, water } = await still(BOX + POOL);
    near(there(world, 'position'), [0, -2, 0]);
    near(there(world, 'size'), [10, 4, 10]);
    // In its own frame.
    near(water.position, [0, 0, 0]);
  });

  it('by what it says itself in the frame of its Transform, scales included', async () => {
    const { world } = await still(
      `${BOX}<transform translation="0 -10 0" rotation="0 1 0 1.5707963" scale="1 2 1"><group>
        <x3d-water-volume id="w" position="3 1 0" size="4 3 2"></x3d-water-volume></group></transform>`,
    );
    near(there(world, 'position'), [0, -8, -3], 1e-5);
    near(there(world, 'size'), [4, 6, 2], 1e-5);
    near(there(world, 'orientation'), [0, 1, 0, Math.PI / 2], 1e-5);
  });

  it('follows its Transforms when they are edited, or moved by a ROUTE', async () => {
    const { x3d, world } = await still(
      `${BOX}<transform id="outer" def="OUTER">${POOL}</transform>
       <positioninterpolator id="tide" def="TIDE" key="0 1" keyvalue="0 0 0 0 1 0"></positioninterpolator>
       <route fromnode="TIDE" fromfield="value_changed" tonode="OUTER" tofield="translation"></route>`,
    );
    x3d.querySelector('#pool')!.setAttribute('translation', '0 -3 0');
    await until(() => there(world, 'position')[1] === -3);
    x3d.querySelector('#outer')!.setAttribute('translation', '0 1 0');
    await until(() => there(world, 'position')[1] === -2);
    const tide = x3d.querySelector('#tide') as Element & {
      setFieldValue(name: string, value: unknown): void;
    };
    tide.setFieldValue('set_fraction', 0.5);
    await until(() => there(world, 'position')[1] === -2.5);
  });

  it('is as large as the Box becomes, and as its own size where that is said', async () => {
    const { x3d, world, water } = await still(BOX + POOL);
    x3d.querySelector('#pool box')!.setAttribute('size', '6 5 4');
    await until(() => there(world, 'size')[0] === 6);
    near(there(world, 'size'), [6, 5, 4]);
    water.size = [1, 2, 3];
    world.step(0);
    near(there(world, 'size'), [1, 2, 3]);
    water.setAttribute('size', '3 3 3');
    await until(() => there(world, 'size')[0] === 3);
    water.removeAttribute('size');
    await until(() => there(world, 'size')[0] === 6);
    x3d.querySelector('#s')!.remove();
    await until(() => there(world, 'size')[0] === 10);
    near(there(world, 'size'), [10, 2, 10]);
  });

  it('stands for what `for` names: a Transform, or a Shape', async () => {
    for (const name of ['pool', 's']) {
      const { world } = await still(
        `${BOX}<x3d-rigid-body-collection><x3d-water-volume id="w" for="${name}"></x3d-water-volume></x3d-rigid-body-collection>
         <x3d-water-volume id="elsewhere" enabled="false"></x3d-water-volume>
         ${POOL.replace(WATER, '')}`,
        '#w',
      );
      near(there(world, 'position'), [0, -2, 0]);
      near(there(world, 'size'), [10, 4, 10]);
    }
  });

  it('is written in the units of its file, as its Transforms and its Box are', async () => {
    const { world, water } = await still(
      `<unit category="length" name="cm" conversionfactor="0.01"></unit>
       <unit category="angle" name="degree" conversionfactor="0.017453292519943295"></unit>
       <transform translation="0 -200 0"><shape><box size="1000 400 500"></box></shape>
         <x3d-water-volume id="w" position="0 0 50" orientation="0 1 0 90" flow="20 0 0"></x3d-water-volume>
       </transform>`,
      '#w',
    );
    near(there(world, 'position'), [0, -2, 0.5]);
    near(there(world, 'size'), [10, 4, 5]);
    near(there(world, 'orientation'), [0, 1, 0, Math.PI / 2]);
    near(there(world, 'flow'), [0.2, 0, 0]);
    near(water.position, [0, 0, 50]);
  });

  it('waits for what it names', async () => {
    const { x3d, world, water } = await still(
      `${BOX}<x3d-water-volume id="w" for="pool"></x3d-water-volume>`,
    );
    expect(world.node(water)).to.equal(undefined);
    claim('[unknown-reference]');
    x3d.querySelector('scene')!.insertAdjacentHTML('beforeend', POOL.replace(WATER, ''));
    await until(() => world.node(water) !== undefined);
    near(there(world, 'position'), [0, -2, 0]);
  });

  it('of a collection weighs by the gravity of that', async () => {
    const { world } = await still(
      `<x3d-rigid-body-collection gravity="0 -1 0">
         <x3d-water-volume id="w" position="0 -1 0"></x3d-water-volume>
         <x3d-rigid-body id="raft" mass="500" position="0 0 0">
           <x3d-collidable-shape><shape><box size="1 1 1"></box></shape></x3d-collidable-shape>
         </x3d-rigid-body>
       </x3d-rigid-body-collection>`,
    );
    world.advance(2);
    near(position(world, 'raft'), [0, 0, 0], 1e-3);
    expect(world.problems).to.eql([]);
  });

  it('has a Shape with which nothing collides, until it goes', async () => {
    const { x3d, world, water } = await still(
      `<transform translation="0 -9 0">
         <transform><shape><box size="1 1 1"></box></shape></transform>${POOL}
         <x3d-rigid-body id="raft" fixed="true"></x3d-rigid-body>
       </transform>`,
    );
    expect(world.raycast([4, 5, 0], [4, -30, 0])).to.equal(null);
    water.remove();
    await until(() => world.raycast([4, 5, 0], [4, -30, 0]) !== null);
    x3d.querySelector('#pool')!.append(water);
    await until(() => world.raycast([4, 5, 0], [4, -30, 0]) === null);
  });

  it('leaves its Shape to a body that stands there, too: a tub', async () => {
    const { world } = await still(
      `<transform translation="0 -2 0">${SHAPE}<x3d-rigid-body id="raft" fixed="true"></x3d-rigid-body>
         <x3d-water-volume id="w" size="2 2 2"></x3d-water-volume></transform>`,
    );
    expect(world.raycast([4, 5, 0], [4, -30, 0])).not.to.equal(null);
    near(there(world, 'size'), [2, 2, 2]);
  });

  it('tells at bodies when they come in and leave, with its own element', async () => {
    for (const pool of [POOL, POOL.replaceAll('x3d-water-volume', 'WaterVolume')]) {
      const { x3d, world } = await still(BOX.replace('0.3', '1.5') + pool);
      const heard: [string, EventTarget | null, CustomEvent['detail']][] = [];
      const note = (event: Event): void => {
        heard.push([event.type, event.target, (event as CustomEvent).detail]);
      };
      for (const type of ['waterenter', 'waterleave'] as const) x3d.addEventListener(type, note);
      world.advance(1);
      const raft = x3d.querySelector('#raft')! as Element & { teleport(p: number[]): void };
      expect(heard.map(([type, target]) => [type, target])).to.eql([['waterenter', raft]]);
      const [[, , detail]] = heard as [(typeof heard)[0]];
      expect(detail.water).to.equal(x3d.querySelector('#w'));
      // From a metre above the surface on, within a step.
      expect(detail.speed).to.be.closeTo(Math.sqrt(2 * 9.8), 0.2);
      expect(detail.depth).to.be.within(0, 0.1);
      expect(detail.time).to.be.closeTo(Math.sqrt(2 / 9.8), 0.02);
      raft.teleport([0, 5, 0]);
      world.step(2);
      expect(heard.map(([type]) => type)).to.eql(['waterenter', 'waterleave']);
    }
  });

  it('comes into a running scene, and goes again', async () => {
    const { x3d, world } = await still(BOX);
    world.advance(0.1);
    const water = document.createElement('x3d-water-volume') as unknown as Water;
    water.density = 1200;
    water.id = 'w';
    x3d.querySelector('scene')!.append(water);
    await until(() => world.node(water) !== undefined);
    expect(there(world, 'density')).to.equal(1200);
    water.remove();
    await until(() => world.node(water) === undefined);
    const [, before] = position(world, 'raft');
    world.advance(1);
    expect(position(world, 'raft')[1]).to.be.below(before! - 4);
    expect(world.problems).to.eql([]);
  });

  it('without any body it has the world of its <x3d>', async () => {
    const x3d = place(POOL);
    const water = x3d.querySelector('#w')!;
    await until(() => worldOf(water) !== undefined);
    await worldOf(water)!.ready;
    expect(worldOf(water)!.problems).to.eql([]);
  });
});
