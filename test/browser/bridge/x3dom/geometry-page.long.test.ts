import { expect } from 'chai';
import { learnShapes } from '../../../../elements/bridge/x3dom/shapes/shapes.js';
import { claim } from '../../console.js';
import { codes, show } from '../../scene.js';

const { nodeTypes } = (globalThis as unknown as { x3dom: { nodeTypes: Record<string, unknown> } })
  .x3dom;

/** x3dom's own node types are functions. */
function drawnBy(name: string): string {
  const type = nodeTypes[name];
  if (!type) return 'nobody';
  return String(type).startsWith('class') ? 'us' : 'x3dom';
}

async function rows(): Promise<string[][]> {
  const page = await (await fetch('/site/guide/geometry.md')).text();
  return [...page.matchAll(/^\| (\w+) \| (.+) \| (\w+) \|$/gm)]
    .map(([, ...cells]) => cells as string[])
    .filter(([name]) => name !== 'geometry');
}

const COORD = '<coordinate point="0 0 0, 1 0 0, 0 1 0"></coordinate>';
const SAMPLES: Record<string, string> = {
  Box: '<box></box>',
  Sphere: '<sphere></sphere>',
  Cylinder: '<cylinder></cylinder>',
  Cone: '<cone></cone>',
  IndexedFaceSet: `<indexedfaceset coordindex="0 1 2 -1">${COORD}</indexedfaceset>`,
  IndexedTriangleSet: `<indexedtriangleset index="0 1 2">${COORD}</indexedtriangleset>`,
  IndexedTriangleStripSet: `<indexedtrianglestripset index="0 1 2 -1">${COORD}</indexedtrianglestripset>`,
  TriangleSet: `<triangleset>${COORD}</triangleset>`,
  Plane: '<plane></plane>',
  Torus: '<torus></torus>',
  Text: '<text string="one"></text>',
  PointSet: `<pointset>${COORD}</pointset>`,
  LineSet: `<lineset vertexcount="3">${COORD}</lineset>`,
  IndexedLineSet: `<indexedlineset coordindex="0 1 2 -1">${COORD}</indexedlineset>`,
};

describe('the page of geometries', () => {
  it('says of each who draws it', async () => {
    await learnShapes();
    const all = await rows();
    expect(all.length).to.be.above(35);
    expect(all.map(([name, , drawn]) => [name, drawn])).to.eql(
      all.map(([name]) => [name, drawnBy(name!)]),
    );
  });

  for (const [name, markup] of Object.entries(SAMPLES)) {
    it(`says of ${name} whether it collides`, async () => {
      const row = (await rows()).find(([each]) => each === name)!;
      const collides = row[1] !== 'nothing';
      if (!collides) claim('waiting-for-geometry');
      const { world } = await show(
        `<transform><shape>${markup}</shape><x3d-rigid-body id="b" fixed></x3d-rigid-body></transform>`,
        '#b',
      );
      expect(codes(world)).to.eql(collides ? [] : ['waiting-for-geometry']);
    });
  }
});
