import { executeServerCommand } from '@web/test-runner-commands';
import { expect } from 'chai';
import '../../console.js';
import { nextFrame, until, wait } from '../../scene.js';
import { bodies, colored, documentOf, draws, errorOf, showBatched } from './pictures.js';

const inChromium = navigator.userAgent.includes('Chrome/');

const boxes = bodies(12, (i) => `${colored(i)}<box size="1 1 1"></box>`);

/** As many come and go at once, half of them beside those that stay, half as a batch of their own. */
const COMING = 100;
/** Rounds until all is as large as it gets, and those that are counted: 10,000 bodies come, 10,000 go. */
const [WARM_UP, ROUNDS] = [12, 100];

/**
 * What one body may leave: half of what the engine's own bookkeeping adds at the most. A body, its nodes and its place in
 * a batch are some kilobytes, one entry of a Map is 40 bytes.
 */
const BYTES = 128;

const coming = bodies(
  COMING,
  (i) => `${colored(i)}${i % 2 ? '<box size="0.5 1 1"></box>' : '<cone></cone>'}`,
)
  .replaceAll(/ id="\w+"/g, '')
  .replaceAll('<transform', '<transform class="more"');

const KINDS = [
  'Buffer',
  'Framebuffer',
  'Program',
  'Query',
  'Renderbuffer',
  'Sampler',
  'Shader',
  'Texture',
  'TransformFeedback',
  'VertexArray',
];

/** Counts the objects of WebGL from now on: made, less those that were deleted. */
function countObjects(context: WebGL2RenderingContext): () => Record<string, number> {
  const gl = context as unknown as Record<string, (...args: unknown[]) => unknown>;
  const counts = Object.fromEntries(KINDS.map((kind) => [kind, 0]));
  for (const kind of KINDS) {
    const [make, remove] = [gl[`create${kind}`]!, gl[`delete${kind}`]!];
    const gone = new WeakSet();
    gl[`create${kind}`] = (...args) => (counts[kind]!++, make.apply(gl, args));
    gl[`delete${kind}`] = (object) => {
      if (object && !gone.has(object)) {
        gone.add(object);
        counts[kind]!--;
      }
      return remove.call(gl, object);
    };
  }
  return () => ({ ...counts });
}

const devtools = (method: string): Promise<{ usedSize: number }> =>
  executeServerCommand('devtools', { method, params: {} });

/** Bytes that JavaScript holds, after collections; 0 where a browser does not say. */
async function heap(): Promise<number> {
  if (!inChromium) return 0;
  // What a collection calls finalizers of is let go by the next one: as many as find something.
  for (let least = Infinity; ;) {
    await devtools('HeapProfiler.collectGarbage');
    await wait(50);
    const { usedSize } = await devtools('Runtime.getHeapUsage');
    if (usedSize >= least) return least;
    least = usedSize;
  }
}

describe('ten thousand bodies that come and go', () => {
  it('leave nothing in WebGL, in JavaScript or in Bullet, and no error', async function () {
    this.timeout(300_000);
    const { x3d, world } = await showBatched(boxes, 1);
    const objects = countObjects(documentOf(x3d).ctx.ctx3d);
    const scene = x3d.querySelector('scene')!;

    async function round(): Promise<void> {
      scene.insertAdjacentHTML('beforeend', coming);
      await until(() => draws(x3d) === 2 && world.stats.bodies === 12 + COMING);
      for (const more of scene.querySelectorAll('.more')) more.remove();
      await until(() => draws(x3d) === 1 && world.stats.bodies === 12);
    }

    const looked = async () => ({
      objects: objects(),
      bullet: world.stats.heapBytes,
      heap: await heap(),
    });
    for (let i = 0; i < WARM_UP; i++) await round();
    const before = await looked();
    for (let i = 0; i < ROUNDS / 2; i++) await round();
    const { heap: between } = await looked();
    for (let i = 0; i < ROUNDS / 2; i++) await round();
    await nextFrame();
    const after = await looked();
    expect(after.objects).to.eql(before.objects);
    expect(after.bullet).to.equal(before.bullet);
    // What bodies leave they leave in both halves; what a compiler makes of code that has run often comes in one of them.
    const left = Math.min(between - before.heap, after.heap - between);
    expect(left).to.be.below((BYTES * COMING * ROUNDS) / 2);
    expect(errorOf(x3d)).to.equal(0);
  });
});
