import { expect } from 'chai';
import { claim } from '../../console.js';
import { codes, drawn, nextFrame, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import {
  bodies,
  colored,
  covered,
  difference,
  documentOf,
  drawPlainly,
  draws,
  picture,
  showBatched,
} from './pictures.js';

const COUNT = 12;
const boxes = bodies(COUNT, (i) => `${colored(i)}<box size="1 1 1"></box>`);

interface Shaders {
  shader: Record<string, { prototype: { generateVertexShader(...args: unknown[]): unknown } }>;
}
const { shader } = (globalThis as unknown as { x3dom: Shaders }).x3dom;

/** An x3dom whose shaders are written otherwise. */
async function withOtherShaders(name: string, test: () => Promise<void>): Promise<void> {
  const { prototype } = shader[name]!;
  const { generateVertexShader } = prototype;
  prototype.generateVertexShader = function (gl, ...args) {
    const own = gl as WebGL2RenderingContext;
    const { shaderSource } = own;
    own.shaderSource = (made, text) =>
      shaderSource.call(
        own,
        made,
        text.replace('vec3 vertPosition = position.xyz;', 'vec3 vertPosition = vec3(position);'),
      );
    try {
      return generateVertexShader.call(this, gl, ...args);
    } finally {
      own.shaderSource = shaderSource;
    }
  };
  try {
    await test();
  } finally {
    prototype.generateVertexShader = generateVertexShader;
  }
}

describe('bodies that look alike', () => {
  it('are drawn one by one where x3dom writes its shaders otherwise, and the page is told once', async () => {
    await withOtherShaders('DynamicShader', async () => {
      claim('[drawing-plain]');
      const { x3d, world } = await show(
        `<viewpoint position="0 0 12"></viewpoint><x3d-rigid-body-collection id="c" default enabled="false"></x3d-rigid-body-collection>${boxes}`,
        '#c',
      );
      await until(() => draws(x3d) > 0 && codes(world).length > 0);
      expect(codes(world)).to.eql(['drawing-plain']);
      expect(world.problems[0]!.severity).to.equal('info');
      expect(draws(x3d)).to.equal(COUNT);
      const before = picture(x3d);
      expect(covered(before)).to.be.above(500);
      x3d.querySelector('#s3 material')!.setAttribute('diffuseColor', '1 0 0');
      await drawn();
      expect(difference(before, picture(x3d)).any).to.be.above(0);
    });
  });

  it('that stand under a Switch as its choices are left to it', async () => {
    const { x3d } = await showBatched(
      `<switch whichchoice="3">${boxes}</switch>${boxes.replaceAll(/ id="\w+"/g, '')}`,
      2,
    );
    expect(draws(x3d)).to.equal(2);
  });

  it('are cut by a ClipPlane as before', async () => {
    const { x3d } = await showBatched(`<clipplane plane="0 1 0 0"></clipplane>${boxes}`, COUNT);
    await wait(300);
    expect(draws(x3d)).to.equal(COUNT);
  });

  it('that stand in two places are drawn one by one in the second', async () => {
    const group = `<group def="G">${boxes}</group>`;
    const { x3d } = await showBatched(
      `${group}<transform translation="0.4 0.3 -4"><group use="G"></group></transform>`,
      1 + COUNT,
    );
    await until(() => draws(x3d) === 1 + COUNT);
    const together = picture(x3d);
    x3d.querySelector('#c')!.setAttribute('batch', 'false');
    await until(() => draws(x3d) === 2 * COUNT);
    expect(difference(together, picture(x3d)).any).to.equal(0);
  });

  it('look as drawn one by one while what they stand in moves', async () => {
    const { x3d, collection } = await showBatched(`<transform id="m">${boxes}</transform>`, 1);
    const above = x3d.querySelector('#m')!;
    const before = picture(x3d);
    above.setAttribute('rotation', '1 1 0 0.4');
    above.setAttribute('scale', '1 0.8 1.1');
    await drawn();
    const together = picture(x3d);
    expect(draws(x3d)).to.equal(1);
    expect(difference(before, together).any).to.be.above(500);
    await drawPlainly(collection, true);
    expect(difference(together, picture(x3d)).any).to.equal(0);
  });

  it('that stand still are brought to WebGL once, however often they are drawn', async () => {
    const { x3d } = await showBatched(boxes, 1);
    picture(x3d);
    const gl = documentOf(x3d).ctx.ctx3d;
    let brought = 0;
    const { bufferData, bufferSubData } = gl;
    gl.bufferData = (...args: unknown[]) => (brought++, Reflect.apply(bufferData, gl, args));
    gl.bufferSubData = (...args: unknown[]) => (brought++, Reflect.apply(bufferSubData, gl, args));
    for (let i = 0; i < 3; i++) picture(x3d);
    expect(brought).to.equal(0);
    x3d.querySelector('viewpoint')!.setAttribute('position', '0 0 11');
    await drawn();
    expect(brought).to.be.above(0);
  });

  it('stay as they are where x3dom reads the page again, and those of another `<x3d>` come to it', async () => {
    const { x3d } = await showBatched(boxes, 1);
    const before = picture(x3d);
    document.body.insertAdjacentHTML(
      'beforeend',
      `<x3d width="200px" height="100px"><scene><viewpoint position="0 0 12"></viewpoint>
        <x3d-rigid-body-collection default enabled="false"></x3d-rigid-body-collection>
        ${boxes}</scene></x3d>`,
    );
    (globalThis as unknown as { x3dom: { reload(): void } }).x3dom.reload();
    const other = document.body.lastElementChild!;
    await worldOf(other)!.ready;
    await until(() => other.querySelector('canvas') !== null && draws(other) === 1);
    expect(draws(x3d)).to.equal(1);
    expect(difference(before, picture(x3d)).any).to.equal(0);
    x3d.querySelector('#s3 material')!.setAttribute('diffuseColor', '1 0 0');
    await drawn();
    expect(draws(x3d)).to.equal(1);
    expect(difference(before, picture(x3d)).any).to.be.above(0);
  });

  it('go with their `<x3d>`, and are drawn in one call again when that is back', async () => {
    const { x3d, world } = await showBatched(boxes, 1);
    const before = picture(x3d);
    const parent = x3d.parentElement!;
    x3d.remove();
    await wait(50);
    parent.append(x3d);
    const again = worldOf(x3d)!;
    await again.ready;
    await until(() => x3d.querySelector('canvas') !== null && draws(x3d) === 1);
    expect(world).to.not.equal(again);
    expect(difference(before, picture(x3d)).any).to.equal(0);
  });

  it('of two `<x3d>` are drawn in one call each', async () => {
    const scene = `<scene><viewpoint position="0 0 12"></viewpoint><x3d-rigid-body-collection default enabled="false"></x3d-rigid-body-collection>${boxes}</scene>`;
    document.body.innerHTML = `<x3d width="200px" height="100px">${scene}</x3d><x3d width="200px" height="100px">${scene}</x3d>`;
    const both = [...document.querySelectorAll('x3d')];
    for (const x3d of both) await worldOf(x3d)!.ready;
    for (const x3d of both)
      await until(() => x3d.querySelector('canvas') !== null && draws(x3d) === 1);
    both[0]!.remove();
    await wait(50);
    both[1]!.querySelector('#s3 material')!.setAttribute('diffuseColor', '1 0 0');
    await nextFrame();
    expect(draws(both[1]!)).to.equal(1);
  });

  it('outlive a lost context: nothing is thrown, then or when their `<x3d>` goes', async () => {
    const { x3d, collection, world } = await showBatched(boxes, 1);
    const canvas = x3d.querySelector('canvas')!;
    const gl = canvas.getContext('webgl2')!;
    const extension = gl.getExtension('WEBGL_lose_context');
    const lost = new Promise((resolve) => canvas.addEventListener('webglcontextlost', resolve));
    extension!.loseContext();
    await lost;
    collection.setAttribute('enabled', 'true');
    await until(() => world.time > 0);
    x3d.querySelector('#t3')!.remove();
    await drawn();
    x3d.remove();
    await wait(50);
  });
});
