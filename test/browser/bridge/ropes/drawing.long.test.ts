import { expect } from 'chai';
import { ropeTags } from '../../../../elements/bridge/index.js';
import { ropesDrawn } from '../../../../elements/bridge/ropes/drawing/ropes-drawn.js';
import { Tube } from '../../../../elements/bridge/ropes/drawing/tube.js';
import type { X3DNode } from '../../../../elements/bridge/x3dom/x3dom.js';
import { documentOf } from '../batch/pictures.js';
import { drawn, show, until } from '../../scene.js';
import { THREADS } from '../../threads.js';
import { inRoots } from '../../../in-roots.js';

// What comes late would have worlds wait for it.
await ropeTags.load();

type Drawn = X3DNode & { renderFlag(): boolean };

const LINE = '<lineset vertexcount="2"><coordinate point="0 2 0 3 2 0"></coordinate></lineset>';

const sceneOf = (appearance: string, radius = '0.1'): string =>
  `<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>
   <transform translation="0 -1 0"><shape id="s">${appearance}${LINE}</shape>
     <x3d-rope id="r" segments="6" radius="${radius}" fixed-index="0"></x3d-rope></transform>`;
const LIT = '<appearance><material></material></appearance>';

/** A rope that has swung for a third of a second. */
async function swung(appearance: string, radius = '0.1') {
  const { x3d, world } = await show(sceneOf(appearance, radius), '#c');
  await until(() => ropesDrawn.here);
  world.paused = true;
  world.reset();
  world.advance(1 / 3);
  await drawn();
  const own = (): Drawn | undefined =>
    documentOf(x3d)._scene._childNodes.find(
      (node) => node._cf.geometry && node._xmlNode === null,
    ) as Drawn | undefined;
  await until(() => own() !== undefined);
  const authors = (x3d.querySelector('#s') as unknown as { _x3domNode: Drawn })._x3domNode;
  const places = (): number[] => (world.node('r')!.get('positions') as number[][]).flat();
  const mesh = () => own()!._cf.geometry!.node!._mesh!;
  return { x3d, world, own, authors, places, mesh };
}

/** Mean of the corners of one ring, without the one that it has twice. */
function middle(positions: ArrayLike<number>, ring: number): number[] {
  const out = [0, 0, 0];
  for (let i = 0; i < 8; i++)
    for (let k = 0; k < 3; k++) out[k]! += positions[3 * (9 * ring + i) + k]! / 8;
  return out;
}

const close = (actual: ArrayLike<number>, expected: ArrayLike<number>, off = 1e-5): void => {
  expect(actual.length).to.equal(expected.length);
  for (let i = 0; i < actual.length; i++) expect(actual[i]).to.be.closeTo(expected[i]!, off);
};

describe('a rope is drawn', () => {
  it('as a tube around its points, instead of its Shape, where that has a Material', async () => {
    const { own, authors, places, mesh } = await swung(LIT);
    expect(mesh()._primType).to.equal('TRIANGLES');
    const rope = places();
    expect(rope.at(-2)).to.be.below(0.9);
    for (let ring = 0; ring < 7; ring++)
      close(middle(mesh()._positions[0]!, ring), rope.slice(3 * ring, 3 * ring + 3));
    expect(authors.renderFlag()).to.equal(false);
    expect(own()!.renderFlag()).to.equal(true);
    expect(own()!._cf.appearance!.node).to.equal(authors._cf.appearance!.node);
  });

  for (const [where, appearance, radius] of [
    ['its Shape has no Material', '<appearance></appearance>', '0.1'],
    ['it has no radius', LIT, '0'],
  ] as const)
    it(`as a line where ${where}`, async () => {
      const { places, mesh } = await swung(appearance, radius);
      expect(mesh()._primType).to.equal('LINES');
      close(mesh()._positions[0]!, places());
      expect(Array.from(mesh()._indices[0]!)).to.eql([0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6]);
    });

  it('where it goes, without a word in the document, and within its bounds', async () => {
    const { x3d, world, own, places, mesh } = await swung(LIT);
    const before = x3d.querySelector('scene')!.outerHTML;
    world.advance(0.4);
    await drawn();
    close(middle(mesh()._positions[0]!, 6), places().slice(-3));
    expect(x3d.querySelector('scene')!.outerHTML).to.equal(before);
    const { min, max } = own()!.getVolume() as Record<'min' | 'max', { x: number; y: number }>;
    const [x, y] = places().slice(-3) as [number, number];
    expect(min.x <= x - 0.1 && max.x >= x + 0.1 && min.y <= y - 0.1 && max.y >= y).to.equal(true);
  });

  it('where it is on another thread', async function () {
    if (!THREADS.includes('worker')) this.skip();
    const { x3d, world } = await show(
      sceneOf(LIT).replace('id="c"', 'id="c" thread="worker"'),
      '#c',
    );
    const positions = (): number[] => (world.node('r')!.get('positions') as number[][]).flat();
    await until(() => positions().at(-2)! < 0.9);
    world.paused = true;
    const own = (): Drawn | undefined =>
      documentOf(x3d)._scene._childNodes.find(
        (node) => node._cf.geometry && node._xmlNode === null,
      ) as Drawn | undefined;
    await until(() => own() !== undefined);
    const end = (): number[] => middle(own()!._cf.geometry!.node!._mesh!._positions[0]!, 6);
    await until(() => Math.hypot(...end().map((x, k) => x - positions().slice(-3)[k]!)) < 0.05);
  });

  it('where x3dom would draw its Shape, and the rope is to be seen', async () => {
    const { x3d, world, own } = await swung(LIT);
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

  it('with more points, or another radius, anew; and its Shape is seen again when it goes', async () => {
    const { x3d, world, own, authors, mesh } = await swung(LIT);
    const rope = x3d.querySelector('#r')!;
    rope.setAttribute('segments', '12');
    rope.setAttribute('radius', '0.2');
    world.step(1);
    await drawn();
    await until(() => mesh()._positions[0]!.length === 3 * 9 * 15);
    const [cx, cy, cz] = middle(mesh()._positions[0]!, 3) as [number, number, number];
    const [x, y, z] = [...(mesh()._positions[0]! as Float32Array).slice(81, 84)] as never[];
    expect(Math.hypot(x - cx, y - cy, z - cz)).to.be.closeTo(0.2, 1e-5);
    rope.remove();
    await until(() => own() === undefined);
    expect(authors.renderFlag()).to.equal(true);
  });
});

describe('a tube', () => {
  /** Along a helix. */
  const helix = (count: number): Float64Array =>
    Float64Array.from({ length: 3 * count }, (_, i) => {
      const t = Math.floor(i / 3) / 4;
      return [Math.cos(t), t / 5, Math.sin(t)][i % 3]!;
    });

  it('has a surface that looks outward everywhere, is closed, and does not twist', () => {
    const tube = new Tube(20, 0.1);
    tube.write(helix(20));
    const { positions, normals, index } = tube;
    const corner = (list: Float32Array, i: number): number[] => [...list.slice(3 * i, 3 * i + 3)];
    let volume = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => corner(positions, index[i + k]!)) as number[][];
      const [u, v] = [b, c].map((p) => p!.map((x, k) => x - a![k]!)) as number[][];
      const across = [
        u![1]! * v![2]! - u![2]! * v![1]!,
        u![2]! * v![0]! - u![0]! * v![2]!,
        u![0]! * v![1]! - u![1]! * v![0]!,
      ];
      const outward = corner(normals, index[i]!);
      expect(across.reduce((sum, x, k) => sum + x * outward[k]!, 0)).to.be.above(0);
      volume += a!.reduce((sum, x, k) => sum + x * across[k]!, 0) / 6;
    }
    const points = helix(20);
    let length = 0;
    for (let i = 3; i < 60; i += 3)
      length += Math.hypot(...[0, 1, 2].map((k) => points[i + k]! - points[i - 3 + k]!));
    // Of a prism with eight sides.
    expect(volume / (length * 2 * Math.SQRT2 * 0.1 ** 2)).to.be.closeTo(1, 0.02);
    for (let ring = 1; ring < 20; ring++) {
      const [a, b] = [ring - 1, ring].map((each) => corner(normals, 9 * each)) as number[][];
      expect(a!.reduce((sum, x, k) => sum + x * b![k]!, 0)).to.be.above(0.95);
    }
  });

  it('stays a number where points fall together or it turns back', () => {
    const tube = new Tube(4, 0.1);
    tube.write(Float64Array.from([0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0]));
    expect([...tube.positions, ...tube.normals].every(Number.isFinite)).to.equal(true);
  });

  it('of a thousand points is written in the time of a few roots for each number of it', () => {
    const tube = new Tube(1000, 0.1);
    const points = helix(1000);
    expect(inRoots(() => tube.write(points), tube.positions.length)).to.be.below(20);
  });
});
