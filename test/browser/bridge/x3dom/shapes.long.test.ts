import { expect } from 'chai';
import { drawn, position, show, until } from '../../scene.js';
import type { World } from '../../inside.js';

interface Mesh {
  _positions: number[][];
  _indices: number[][];
  _normals: number[][];
  _colors: number[][];
  _texCoords: number[][];
}
const meshOf = (element: Element): Mesh | undefined =>
  (element as unknown as { _x3domNode?: { _mesh: Mesh } })._x3domNode?._mesh;

const body = (geometry: string): string =>
  `<transform translation="0 0 0"><shape><appearance><material></material></appearance>${geometry}</shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>
  <transform translation="0.2 3 0.3"><shape><sphere radius="0.2"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`;

const COORD = '<coordinate point="-2 1 2, 2 1 2, 2 1 -2, -2 1 -2"></coordinate>';

/** Each has its upper side at 1 m, around the origin; how many triangles it has. */
const SHAPES: [markup: string, triangles: number][] = [
  [
    '<elevationgrid xDimension="3" zDimension="3" xSpacing="2" zSpacing="2" height="1 1 1 1 1 1 1 1 1"></elevationgrid>',
    8,
  ],
  ['<extrusion crossSection="2 2, 2 -2, -2 -2, -2 2, 2 2"></extrusion>', 12],
  [`<trianglefanset fanCount="4">${COORD}</trianglefanset>`, 2],
  [
    `<trianglestripset stripCount="4"><coordinate point="-2 1 2, 2 1 2, -2 1 -2, 2 1 -2"></coordinate></trianglestripset>`,
    2,
  ],
  [`<quadset>${COORD}</quadset>`, 2],
  [`<indexedtrianglefanset index="0 1 2 3 -1">${COORD}</indexedtrianglefanset>`, 2],
  [`<indexedquadset index="0 1 2 3">${COORD}</indexedquadset>`, 2],
];

async function rest(world: World): Promise<number> {
  world.paused = true;
  world.reset();
  world.advance(3);
  await drawn();
  return position(world, 'ball')[1];
}

describe('geometry that x3dom lacks', () => {
  for (const [markup, triangles] of SHAPES) {
    const tag = markup.match(/\w+/)![0];
    it(`${tag} is drawn with the triangles that a ball lies on`, async () => {
      const { x3d, world } = await show(body(markup), '#b');
      expect(await rest(world)).to.be.closeTo(1.2, 0.02);
      const mesh = meshOf(x3d.querySelector(tag)!)!;
      expect(mesh._indices[0].length).to.equal(3 * triangles);
      expect(mesh._normals[0].length).to.equal(9 * triangles);
      expect(mesh._texCoords[0].length).to.equal(6 * triangles);
      // One of them lies at 1 m and faces up.
      const up = mesh._normals[0].findIndex((value, i) => i % 3 === 1 && value > 0.99);
      expect(mesh._positions[0][up]).to.be.closeTo(1, 1e-6);
      expect(world.problems).to.eql([]);
    });
  }

  it('Rectangle2D and Disk2D are drawn as they collide', async () => {
    const { x3d, world } = await show(
      `<transform translation="0 1 0" rotation="1 0 0 -1.5707963"><shape><rectangle2d size="4 4"></rectangle2d></shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>
       <transform translation="9 1 0" rotation="1 0 0 -1.5707963"><shape><disk2d outerradius="2"></disk2d></shape><x3d-rigid-body fixed></x3d-rigid-body></transform>
       <transform translation="0.2 3 0.3"><shape><sphere radius="0.2"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`,
      '#b',
    );
    expect(await rest(world)).to.be.closeTo(1.2, 0.02);
    expect(meshOf(x3d.querySelector('rectangle2d')!)!._indices[0].length).to.equal(6);
    expect(meshOf(x3d.querySelector('disk2d')!)!._indices[0].length).to.be.above(90);
  });

  it('ElevationGrid has the colours, normals, crease angle and texture coordinates of its fields', async () => {
    const grid = (fields: string, children = ''): string =>
      `<transform><shape><elevationgrid id="g" xDimension="2" zDimension="3" height="0 1 0 1 0 0" ${fields}>${children}</elevationgrid></shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>`;
    const read = async (fields: string, children?: string): Promise<Mesh> => {
      const { x3d } = await show(grid(fields, children), '#b');
      return meshOf(x3d.querySelector('#g')!)!;
    };
    const flat = await read('');
    const smooth = await read('creaseAngle="3"');
    const same = (mesh: Mesh): boolean =>
      [0, 1, 2].every((i) => mesh._normals[0][i] === mesh._normals[0][3 + i]);
    expect([same(flat), same(smooth)]).to.eql([true, false]);
    expect(Math.max(...flat._texCoords[0])).to.equal(1);

    const perQuad = await read('colorPerVertex="false"', '<color color="1 0 0 0 0 1"></color>');
    expect(perQuad._colors[0].slice(0, 18)).to.eql(Array(6).fill([1, 0, 0]).flat());
    expect(perQuad._colors[0].slice(18)).to.eql(Array(6).fill([0, 0, 1]).flat());
    const perPoint = await read(
      '',
      '<color color="0 0 0 .1 0 0 .2 0 0 .3 0 0 .4 0 0 .5 0 0"></color>',
    );
    expect(perPoint._colors[0].length).to.equal(36);
    expect(perPoint._colors[0].filter((_, i) => i % 3 === 0).slice(0, 3)).to.eql([0, 0.2, 0.3]);
    const given = await read(
      '',
      '<normal vector="0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1"></normal><texturecoordinate point="0 0 .5 0 0 .5 .5 .5 0 1 .5 1"></texturecoordinate>',
    );
    expect(given._normals[0].slice(0, 3)).to.eql([0, 0, 1]);
    expect(Math.max(...given._texCoords[0].filter((_, i) => i % 2 === 0))).to.equal(0.5);
  });

  it('follows edits: of a field, of a child, and one that comes later', async () => {
    const { x3d, world } = await show(body(SHAPES[0]![0]), '#b');
    const grid = x3d.querySelector('elevationgrid')!;
    grid.setAttribute('height', '2 2 2 2 2 2 2 2 2');
    await until(() => meshOf(grid)!._positions[0][1] === 2);
    expect(await rest(world)).to.be.closeTo(2.2, 0.02);
    x3d
      .querySelector('scene')!
      .insertAdjacentHTML('beforeend', `<shape id="late">${SHAPES[3]![0]}</shape>`);
    const late = x3d.querySelector('#late')!.firstElementChild!;
    await until(() => (meshOf(late)?._indices[0].length ?? 0) > 0);
  });

  it('is left to x3dom where that has it', async () => {
    const { nodeTypes } = (
      globalThis as unknown as { x3dom: { nodeTypes: Record<string, unknown> } }
    ).x3dom;
    expect('surface' in (nodeTypes.IndexedTriangleSet as { prototype: object }).prototype).to.equal(
      false,
    );
    const { x3d } = await show(
      body(`<indexedtrianglestripset index="0 1 3 2 -1">${COORD}</indexedtrianglestripset>`),
      '#b',
    );
    const node = (x3d.querySelector('indexedtrianglestripset') as unknown as { _x3domNode: object })
      ._x3domNode;
    expect('surface' in node).to.equal(false);
  });
});
