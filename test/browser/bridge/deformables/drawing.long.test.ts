import { expect } from 'chai';
import { Skin } from '../../../../elements/bridge/deformables/drawing/skin.js';
import { textureOn } from '../../../../elements/bridge/deformables/drawing/texture-on.js';
import { deformablesDrawn } from '../../../../elements/bridge/deformables/drawing/deformables-drawn.js';
import { deformableTags } from '../../../../elements/bridge/index.js';
import { meshes } from '../../../../physics-core/inside.js';
import type { X3DNode } from '../../../../elements/bridge/x3dom/x3dom.js';
import { documentOf, picture } from '../batch/pictures.js';
import { drawn, show, until } from '../../scene.js';
import { THREADS } from '../../threads.js';
import { inRoots } from '../../../in-roots.js';

// What comes late would have worlds wait for it.
await deformableTags.load();

type Drawn = X3DNode & { renderFlag(): boolean };
type Lists = Record<'_positions' | '_normals' | '_texCoords' | '_indices', ArrayLike<number>[]>;

const LIT = '<appearance><material></material></appearance>';
/** Level, and held at its edge behind. */
const sceneOf = (geometry = '', cloth = 'size="2 2" subdivision="4 4"'): string =>
  `<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>
   <transform translation="0 -1 0" rotation="1 0 0 1.5707963"><shape id="s">${LIT}${geometry}</shape>
     <x3d-cloth id="r" ${cloth} fixedIndex="0 1 2 3 4"></x3d-cloth></transform>`;

/** A cloth that has swung for a third of a second. */
async function swung(geometry?: string, cloth?: string) {
  const { x3d, world } = await show(sceneOf(geometry, cloth), '#c');
  await until(() => deformablesDrawn.here);
  world.paused = true;
  world.reset();
  world.advance(1 / 3);
  await drawn();
  const all = (): Drawn[] =>
    documentOf(x3d)._scene._childNodes.filter(
      (node) => node._cf.geometry && node._xmlNode === null,
    ) as Drawn[];
  const own = (): Drawn | undefined => all()[0];
  await until(() => own() !== undefined);
  const authors = (x3d.querySelector('#s') as unknown as { _x3domNode: Drawn })._x3domNode;
  const places = (): number[] => (world.node('r')!.get('positions') as number[][]).flat();
  const mesh = () => own()!._cf.geometry!.node!._mesh! as never as Lists;
  return { x3d, world, all, own, authors, places, mesh };
}

const close = (actual: ArrayLike<number>, expected: ArrayLike<number>, off = 1e-5): void => {
  expect(actual.length).to.equal(expected.length);
  for (let i = 0; i < actual.length; i++) expect(actual[i]).to.be.closeTo(expected[i]!, off);
};

/** The corners of a mesh by what they are of the surface: where each point of it is drawn. */
const sorted = (list: ArrayLike<number>): string[] => {
  const out: string[] = [];
  for (let i = 0; i < list.length; i += 3)
    out.push([0, 1, 2].map((k) => (list[i + k]! + 0).toFixed(4)).join(' '));
  return out.sort();
};

describe('a cloth is drawn', () => {
  it('where its points are, instead of its Shape', async () => {
    const { own, authors, places, mesh } = await swung();
    expect(Math.min(...places())).to.be.below(-1.3);
    expect(sorted(mesh()._positions[0]!)).to.eql(sorted(places()));
    expect(mesh()._indices[0]!.length).to.equal(3 * 32);
    expect(authors.renderFlag()).to.equal(false);
    expect(own()!.renderFlag()).to.equal(true);
    expect(own()!._cf.appearance!.node).to.equal(authors._cf.appearance!.node);
    expect(own()!._cf.geometry!.node!._vf.solid).to.equal(false);
  });

  it('with the picture of its Appearance from corner to corner', async () => {
    const { mesh } = await swung();
    const { _positions: positions, _texCoords: texture } = mesh();
    expect(Math.max(...Array.from(texture[0]!))).to.equal(1);
    expect(texture[0]!.length / 2).to.equal(positions[0]!.length / 3);
  });

  it('with the texture coordinates of its geometry, point by point and face by face', async () => {
    const points = '<coordinate point="0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0"></coordinate>';
    const triangles = await swung(
      `<indexedtriangleset index="0 1 2 0 2 3">${points}
         <texturecoordinate point="0.1 0.1 0.9 0.1 0.9 0.9 0.1 0.9 0 0 0 0"></texturecoordinate></indexedtriangleset>`,
      '',
    );
    close(triangles.mesh()._texCoords[0]!, [0.1, 0.1, 0.9, 0.1, 0.9, 0.9, 0.1, 0.9]);
    const faces = await swung(
      `<indexedfaceset coordindex="0 1 2 3 -1 1 4 5 2 -1" texcoordindex="0 1 2 3 -1 0 1 2 3 -1">${points}
         <texturecoordinate point="0 0 1 0 1 1 0 1"></texturecoordinate></indexedfaceset>`,
      '',
    );
    const { _positions: places, _texCoords: texture } = faces.mesh();
    // Each face has the whole of it: the edge between them has its corners twice.
    expect(places[0]!.length).to.equal(3 * 8);
    const sum = Array.from(texture[0]!).reduce((a, b) => a + b, 0);
    expect(sum).to.equal(8);
  });

  it('where it goes, without a word in the document, and within its bounds', async () => {
    const { x3d, world, own, places, mesh } = await swung();
    const before = x3d.querySelector('scene')!.outerHTML;
    world.advance(0.4);
    await drawn();
    expect(sorted(mesh()._positions[0]!)).to.eql(sorted(places()));
    expect(x3d.querySelector('scene')!.outerHTML).to.equal(before);
    const { min, max } = own()!.getVolume() as Record<'min' | 'max', { x: number; y: number }>;
    const all = places();
    for (let i = 0; i < all.length; i += 3)
      expect(min.x <= all[i]! && max.x >= all[i]! && min.y <= all[i + 1]!).to.equal(true);
  });

  it('where it is on another thread', async function () {
    if (!THREADS.includes('worker')) this.skip();
    const { x3d, world } = await show(sceneOf().replace('id="c"', 'id="c" thread="worker"'), '#c');
    const positions = (): number[] => (world.node('r')!.get('positions') as number[][]).flat();
    await until(() => Math.min(...positions()) < -1.5);
    world.paused = true;
    const own = (): Drawn | undefined =>
      documentOf(x3d)._scene._childNodes.find(
        (node) => node._cf.geometry && node._xmlNode === null,
      ) as Drawn | undefined;
    await until(() => own() !== undefined);
    const least = (list: ArrayLike<number>): number => Math.min(...Array.from(list));
    const mesh = (): Lists => own()!._cf.geometry!.node!._mesh! as never;
    await until(() => Math.abs(least(mesh()._positions[0]!) - least(positions())) < 0.05);
  });

  it('where x3dom would draw its Shape, and the cloth is to be seen', async () => {
    const { x3d, world, own } = await swung();
    for (const selector of ['transform', '#s', '#r']) {
      const element = x3d.querySelector(selector)!;
      element.setAttribute('visible', 'false');
      element.setAttribute('render', 'false');
      world.step(1);
      await until(() => !own()!.renderFlag());
      element.setAttribute('visible', 'true');
      element.setAttribute('render', 'true');
      world.step(1);
      await until(() => own()!.renderFlag());
    }
  });

  it('with more cells anew; and its Shape is seen again when it goes', async () => {
    const { x3d, world, own, authors, mesh } = await swung();
    const cloth = x3d.querySelector('#r')!;
    cloth.setAttribute('subdivision', '8 8');
    world.step(1);
    await until(() => mesh()._positions[0]!.length === 3 * 81);
    cloth.remove();
    await until(() => own() === undefined);
    expect(authors.renderFlag()).to.equal(true);
  });

  it('without the triangles that a torn one has no more', async () => {
    const { world, own, mesh } = await swung();
    const node = world.node('r') as unknown as { triangles: Int32Array };
    const { triangles } = node;
    const say = (left: Int32Array): unknown =>
      Object.defineProperty(node, 'triangles', { value: left, configurable: true });
    say(triangles.subarray(6));
    world.step(1);
    await until(() => mesh()._indices[0]!.length === triangles.length - 6);
    say(new Int32Array(0));
    world.step(1);
    await until(() => own() === undefined);
    say(triangles.slice());
    world.step(1);
    await until(() => own() !== undefined && mesh()._indices[0]!.length === triangles.length);
  });

  it('in the colours that a picture has there: from both sides', async () => {
    const pixels = async (turn: string): Promise<number[]> => {
      const { x3d, world } = await show(
        `<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection><viewpoint position="0 0 4"></viewpoint>
         <transform rotation="${turn}"><shape><appearance><material diffuseColor="1 0 0"></material></appearance></shape>
           <x3d-cloth id="r" size="2 2" subdivision="4 4" enabled="false"></x3d-cloth></transform>`,
        '#c',
      );
      await until(() => deformablesDrawn.here);
      world.step(1);
      const middle = (): number[] => {
        const list = picture(x3d);
        const [width, height] = [300, 200];
        const at = 4 * (width * (height / 2) + width / 2);
        return [...list.slice(at, at + 3)];
      };
      await until(() => middle()[0]! > 100);
      return middle();
    };
    const [front, behind] = [await pixels('0 1 0 0'), await pixels('0 1 0 3.14159265')];
    expect(front![1]).to.be.below(60);
    front!.forEach((value, i) => expect(value).to.be.closeTo(behind![i]!, 3));
  });

  it('each of several by itself', async () => {
    const { x3d, world, all } = await swung();
    x3d
      .querySelector('scene')!
      .append(
        document
          .createRange()
          .createContextualFragment(
            `<transform translation="3 0 0"><shape>${LIT}</shape><x3d-cloth size="1 1" subdivision="1 1"></x3d-cloth></transform>`,
          ),
      );
    world.paused = false;
    await until(() => all().length === 2);
    const sizes = all().map((each) => each._cf.geometry!.node!._mesh!._positions[0]!.length);
    expect(sizes).to.eql([75, 12]);
  });
});

const BOX = { geometry: { type: 'Box', size: [2, 2, 2] } };

describe('a skin', () => {
  const box = {
    points: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
      i & 1 ? 1 : -1,
      i & 2 ? 1 : -1,
      i & 4 ? 1 : -1,
    ]),
    index: Int32Array.from([
      0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1,
      3, 7, 1, 7, 5,
    ]),
  };
  const draw = (index = box.index): Skin => {
    const skin = new Skin(box.points, index, textureOn(box.points, index, BOX));
    skin.write(Float64Array.from(box.points));
    return skin;
  };

  it('of a box has edges, with the whole of a picture on each side; its normals have a length of 1', () => {
    const edged = draw();
    expect(edged.positions.length).to.equal(3 * 24);
    for (let i = 0; i < 72; i += 3)
      expect(Math.max(...[0, 1, 2].map((k) => Math.abs(edged.normals[i + k]!)))).to.equal(1);
    expect(Array.from(edged.texCoords).reduce((a, b) => a + b, 0)).to.equal(24);
  });

  it('of a ball is round, and has the picture once around it, and from pole to pole', () => {
    const { points, index } = meshes.code.tessellate({ type: 'Sphere', radius: 2 });
    const all = Int32Array.from(index);
    const ball = { geometry: { type: 'Sphere', radius: 2 } };
    const skin = new Skin(points, all, textureOn(points, all, ball));
    skin.write(Float64Array.from(points));
    const { positions, normals, texCoords } = skin;
    for (let i = 0; i < positions.length; i += 3)
      for (let k = 0; k < 3; k++)
        expect(normals[i + k]! - positions[i + k]! / 2).to.be.closeTo(0, 0.1);
    for (let n = 0; n < skin.index.length; n += 3) {
      const s = [0, 1, 2].map((k) => texCoords[2 * skin.index[n + k]!]!);
      expect(Math.max(...s) - Math.min(...s)).to.be.below(0.1);
    }
    for (let i = 0; 3 * i < positions.length; i++)
      expect(texCoords[2 * i + 1]).to.be.closeTo(
        0.5 + Math.asin(positions[3 * i + 1]! / 2) / Math.PI,
        1e-5,
      );
  });

  it('follows triangles that go, and points that fall together', () => {
    const torn = draw(box.index.slice(0, 6));
    torn.write(new Float64Array(24));
    expect(torn.index.length).to.equal(6);
    expect([...torn.positions, ...torn.normals].every(Number.isFinite)).to.equal(true);
  });

  it('goes round where points stand twice for a picture, and has that as its author says', () => {
    const points = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0];
    const all = Int32Array.from([0, 1, 2, 3, 4, 5]);
    const places = [0, 0, 1, 0, 1, 1, 0.5, 0.5, 0.6, 0.6, 0, 1];
    const skin = new Skin(points, all, { places, index: all });
    const bent = Float64Array.from(points);
    bent[5] = bent[17] = 1;
    skin.write(bent);
    close(skin.texCoords, places);
    const normal = (i: number): number[] => [...skin.normals.slice(3 * i, 3 * i + 3)];
    expect(normal(0)).to.eql(normal(3));
    expect(normal(2)).to.eql(normal(4));
  });

  it('of ten thousand points is written in the time of a few roots for each number of it', () => {
    const side = 100;
    const points: number[] = [];
    const index: number[] = [];
    for (let j = 0; j < side; j++) for (let i = 0; i < side; i++) points.push(i, j, 0);
    for (let j = 0; j + 1 < side; j++)
      for (let i = 0; i + 1 < side; i++) {
        const a = j * side + i;
        index.push(a, a + 1, a + side, a + 1, a + side + 1, a + side);
      }
    const all = Int32Array.from(index);
    const skin = new Skin(points, all, textureOn(points, all, undefined));
    const places = Float64Array.from(points);
    expect(inRoots(() => skin.write(places), places.length)).to.be.below(25);
  });
});
