import { expect } from 'chai';
import { waterTags } from '../../../../elements/bridge/index.js';
import { surfaces } from '../../../../elements/bridge/water/surface/surfaces.js';
import { SurfaceMesh } from '../../../../elements/bridge/water/surface/mesh.js';
import type { X3DNode } from '../../../../elements/bridge/x3dom/x3dom.js';
import type { WaterVolumeNode } from '../../../../physics-core/water.js';
import { documentOf } from '../batch/pictures.js';
import { drawn, show, until } from '../../scene.js';
import { inRoots } from '../../../in-roots.js';

// What comes late would have worlds wait for it.
await waterTags.load();

const STONE = `<transform translation="1 1.5 0">
    <shape><box size="1 1 1"></box></shape><x3d-rigid-body id="stone" mass="1500"></x3d-rigid-body>
  </transform>`;
/** Its surface is at y = 0. */
const POOL = `<transform translation="0 -2 0"><shape id="s"><appearance></appearance><box size="10 4 8"></box></shape>
    <x3d-water-volume id="w" waves="true" subdivision="20 16"></x3d-water-volume></transform>`;

type Drawn = X3DNode & { renderFlag(): boolean };

/** Half a second after a stone began to fall in. */
async function splashed() {
  const { x3d, world } = await show(STONE + POOL, '#stone');
  await until(() => surfaces.here);
  world.paused = true;
  world.reset();
  world.advance(1);
  await drawn();
  const own = (): Drawn | undefined =>
    documentOf(x3d)._scene._childNodes.find(
      (node) => node._cf.geometry && node._xmlNode === null,
    ) as Drawn | undefined;
  const boxes = (x3d.querySelector('#s') as unknown as { _x3domNode: Drawn })._x3domNode;
  return { x3d, world, own, boxes };
}

describe('a surface of water in a page', () => {
  it('is drawn as one mesh by its heights, instead of its Shape', async () => {
    const { world, own, boxes } = await splashed();
    await until(() => own() !== undefined);
    const { heights } = (world.node('w') as WaterVolumeNode).surface!;
    expect(Math.max(...heights)).to.be.above(0.01);
    const points = own()!._cf.geometry!.node!._mesh!._positions[0]!;
    // A corner in the middle, between four cells.
    const at = 3 * (8 * 21 + 12);
    const around = [7 * 20 + 11, 7 * 20 + 12, 8 * 20 + 11, 8 * 20 + 12].map(
      (cell) => heights[cell]!,
    );
    const mean = around.reduce((sum, each) => sum + each) / 4;
    expect(points[at]).to.be.closeTo(1, 1e-6);
    expect(points[at + 1]).to.be.closeTo(mean, 1e-6);
    expect(points[at + 2]).to.be.closeTo(0, 1e-6);
    expect(boxes.renderFlag()).to.equal(false);
    expect(own()!.renderFlag()).to.equal(true);
    expect(own()!._cf.appearance!.node).to.equal(boxes._cf.appearance!.node);
  });

  it('whose waves end is drawn as its Shape again', async () => {
    const { x3d, world, own, boxes } = await splashed();
    await until(() => own() !== undefined);
    x3d.querySelector('#w')!.setAttribute('waves', 'false');
    await until(() => (world.node('w') as WaterVolumeNode).surface === undefined);
    world.step();
    await until(() => own() === undefined);
    expect(boxes.renderFlag()).to.equal(true);
  });

  it('of 128 × 128 cells is written in the time of a few roots for each number of it', () => {
    const heights = new Float32Array(128 * 128).map((_, i) => Math.sin(i) / 10);
    const shown = { columns: 128, rows: 128, width: 20, length: 20, heights, version: 1 };
    const mesh = new SurfaceMesh(shown);
    const place = { axes: [1, 0, 0, 0, 1, 0, 0, 0, 1], middle: [0, -1, 0], depth: 2, unit: 1 };
    expect(inRoots(() => mesh.write(shown, place), mesh.positions.length)).to.be.below(10);
  });
});
