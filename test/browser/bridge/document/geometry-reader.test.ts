import { expect } from 'chai';
import { claim } from '../../console.js';
import { nextFrame, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

type Data = Record<string, unknown>;

async function shapeOf(shape: string, above = ''): Promise<Data> {
  const { world } = await show(
    `${above}<x3d-rigid-body-collection id="c"><x3d-rigid-body><x3d-collidable-shape id="s">${shape}</x3d-collidable-shape></x3d-rigid-body></x3d-rigid-body-collection>`,
    '#c',
  );
  await wait(20);
  return (world.node('s')!.get('shape') as Data[])[0];
}

describe('geometry', () => {
  it('is read with X3D fields and defaults', async () => {
    expect(await shapeOf('<shape><box size="1 2 3"></box></shape>')).to.deep.include({
      type: 'Box',
      size: [1, 2, 3],
    });
    expect(await shapeOf('<shape><cylinder radius="0.5"></cylinder></shape>')).to.deep.include({
      type: 'Cylinder',
      radius: 0.5,
    });
    const faces =
      '<shape><indexedfaceset coordindex="0 1 2 -1"><coordinate point="0 0 0, 1 0 0, 0 1 0"></coordinate></indexedfaceset></shape>';
    expect(await shapeOf(faces)).to.deep.include({
      type: 'IndexedFaceSet',
      coordIndex: [0, 1, 2, -1],
      coord: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    });
  });

  it('may be USEd, Shape, geometry or Coordinate', async () => {
    const def = '<shape def="sh"><sphere def="sp" radius="3"></sphere></shape>';
    expect(await shapeOf('<shape use="sh"></shape>', def)).to.deep.include({
      type: 'Sphere',
      radius: 3,
    });
    expect(await shapeOf('<shape><sphere use="sp"></sphere></shape>', def)).to.deep.include({
      type: 'Sphere',
      radius: 3,
    });
  });

  it("is x3dom's triangles where X3D names no shape of ours", async () => {
    claim('concave-dynamic');
    const torus = await shapeOf('<shape><torus innerradius="0.2" outerradius="1"></torus></shape>');
    expect(torus.type).to.equal('Mesh');
    expect((torus.index as number[]).length).to.be.above(100);
    const far = Math.max(...(torus.points as number[]));
    document.querySelector('torus')!.setAttribute('outerradius', '3');
    await wait(30);
    const body = document.querySelector('#s')!;
    await until(() => {
      const [wider] = worldOf(body)!.node(body)!.get('shape') as { points: number[] }[];
      return Math.max(...wider.points) > 1.5 * far;
    });
  });

  it('takes the place and scale of the Transforms between', async () => {
    const moved = await shapeOf(
      '<transform translation="1 2 3" scale="2 2 2"><shape><sphere></sphere></shape></transform>',
    );
    expect(moved).to.deep.include({
      type: 'Sphere',
      translation: [1, 2, 3],
      linear: [2, 0, 0, 0, 2, 0, 0, 0, 2],
    });
  });

  it('follows edits, swaps and removal', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t"><shape id="shape"><box id="box" size="1 1 1"></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.paused = true;
    const shapes = (): Data[] => {
      world.step(0);
      const [collidable] = world.node('b')!.get('geometry') as { get(name: string): Data[] }[];
      return collidable.get('shape');
    };
    const destroyed = world.stats.destroyed;
    x3d.querySelector('#box')!.setAttribute('size', '2 2 2');
    expect(shapes()[0].size).to.eql([2, 2, 2]);
    x3d.querySelector('#shape')!.innerHTML = '<sphere radius="4"></sphere>';
    expect(shapes()[0]).to.deep.include({ type: 'Sphere', radius: 4 });
    await nextFrame();
    x3d.querySelector('sphere')!.removeAttribute('radius');
    expect(shapes()[0].radius).to.equal(undefined);
    x3d.querySelector('#shape')!.insertAdjacentHTML('afterend', '<shape><box></box></shape>');
    expect(shapes().length).to.equal(2);
    x3d.querySelector('#shape')!.remove();
    expect(shapes().map(({ type }) => type)).to.eql(['Box']);
    expect(world.stats.destroyed).to.equal(destroyed);
  });

  it('a Shape belongs to the nearest body up the tree', async () => {
    const { x3d } = await show(
      `
      <transform id="outer"><shape><box></box></shape><x3d-rigid-body id="a"></x3d-rigid-body>
        <group><transform translation="0 5 0"><shape><sphere></sphere></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform></group>
        <transform translation="0 2 0"><shape><cone></cone></shape></transform>
      </transform>`,
      '#a',
    );
    const types = (id: string): unknown[] => {
      const world = worldOf(x3d.querySelector(`#${id}`)!)!;
      const [collidable] = world.node(id)!.get('geometry') as { get(name: string): Data[] }[];
      return collidable.get('shape').map(({ type }) => type);
    };
    expect(types('a')).to.eql(['Box', 'Cone']);
    expect(types('b')).to.eql(['Sphere']);
  });
});
