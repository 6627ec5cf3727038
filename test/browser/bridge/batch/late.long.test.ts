import { expect } from 'chai';
import '../../console.js';
import { drawn, until } from '../../scene.js';
import { bodies, colored, draws, drawPlainly, picture, showBatched, wrapped } from './pictures.js';

const COUNT = 12;
const boxes = bodies(COUNT, (i) => `${colored(i)}<box size="0.6 0.6 0.6"></box>`);
const spun = boxes.replaceAll('<x3d-rigid-body', '<x3d-rigid-body angularvelocity="1 2 3"');

const SCENES: Record<string, string> = {
  '': spun,
  ', with a scale and a centre': spun.replaceAll(
    '<transform',
    '<transform scale="1 2 0.5" center="0.3 0 0.1"',
  ),
  ', in groups of their own': wrapped(spun),
  ', under a Transform': `<transform id="above" translation="0 1 0" rotation="0 0 1 0.5" scale="1 0.7 1.2">${spun}</transform>`,
};

type Shown = Awaited<ReturnType<typeof showBatched>>;

interface Node {
  _trafo: Record<string, number>;
  _vf: Record<string, Record<string, number>>;
  getCurrentTransform(): unknown;
  getVolume(): Record<'min' | 'max', Record<string, number>>;
  doIntersect(line: unknown): boolean;
}

interface Runtime {
  getBBox(element: Element): unknown;
  getSceneBBox(): unknown;
  projectionMatrix(): unknown;
}

const find = ({ x3d }: Shown, name: string): Element => x3d.querySelector(name)!;
const nodeOf = (shown: Shown, name = '#t3'): Node =>
  (find(shown, name) as unknown as { _x3domNode: Node })._x3domNode;
const runtimeOf = ({ x3d }: Shown): Runtime => (x3d as unknown as { runtime: Runtime }).runtime;
const fieldOf = (shown: Shown, name: string): unknown =>
  (find(shown, '#t3') as unknown as { getFieldValue(name: string): unknown }).getFieldValue(name);

/** It falls and turns for some seconds, and stands still then. */
async function fall({ world, collection }: Shown, seconds = 0.1): Promise<void> {
  collection.setAttribute('enabled', 'true');
  world.paused = true;
  world.advance(seconds);
  await drawn();
}

/** What x3dom finds of it along a line that goes through it, in the frame that it stands in. */
function hit(shown: Shown): unknown {
  const { fields } = (globalThis as any).x3dom;
  const node = nodeOf(shown);
  const { min, max } = node.getVolume();
  const line = new fields.Ray(
    new fields.SFVec3f((min.x + max.x) / 2, (min.y + max.y) / 2, 50),
    new fields.SFVec3f(0, 0, -1),
  );
  return [node.doIntersect(line), line.hitPoint, line.dist];
}

/** Whoever may ask where a body is. */
const READERS: Record<string, (shown: Shown) => unknown> = {
  'the matrix': (shown) => nodeOf(shown)._trafo,
  'the matrix, copied': (shown) => ({ ...nodeOf(shown)._trafo }),
  'the matrix of all above it': (shown) => nodeOf(shown).getCurrentTransform(),
  'the field `translation`': (shown) => fieldOf(shown, 'translation'),
  'the field `rotation`': (shown) => fieldOf(shown, 'rotation'),
  'the fields, copied': (shown) => ({ ...nodeOf(shown)._vf }).rotation,
  'its bounds': (shown) => runtimeOf(shown).getBBox(find(shown, '#t3')),
  'its volume': (shown) => {
    const { min, max } = nodeOf(shown).getVolume();
    return [min, max];
  },
  'the bounds of the scene': (shown) => runtimeOf(shown).getSceneBBox(),
  'the near and the far plane': (shown) => {
    picture(shown.x3d);
    return runtimeOf(shown).projectionMatrix();
  },
  'a line through it': hit,
};

/** What each of them finds, in words, to the last bit: after a fall of its own, since who reads has all brought up to date. */
async function findings(shown: Shown): Promise<Record<string, string>> {
  const found: Record<string, string> = {};
  for (const [name, reader] of Object.entries(READERS)) {
    await fall(shown, 0.05);
    found[name] = JSON.stringify(reader(shown));
  }
  return found;
}

/** What `look` gives of bodies that are drawn one by one, and of the same in one call. */
async function bothWays<T>(scene: string, look: (shown: Shown) => Promise<T>): Promise<[T, T]> {
  const plain = await showBatched(scene, 1);
  await drawPlainly(plain.collection, true);
  const byThemselves = await look(plain);
  expect(draws(plain.x3d)).to.be.at.least(COUNT - 1);
  return [byThemselves, await look(await showBatched(scene, 1))];
}

describe('bodies that fall, drawn in one call,', () => {
  for (const [where, scene] of Object.entries(SCENES))
    it(`are found by whoever asks where they are drawn one by one${where}`, async () => {
      const [plain, together] = await bothWays(scene, findings);
      expect(together).to.eql(plain);
      expect(new Set(Object.values(plain)).size).to.be.above(8);
    });

  it('write nothing into x3dom’s Transforms as long as nobody reads those, after an edit neither', async () => {
    const shown = await showBatched(spun, 1);
    await fall(shown);
    find(shown, '#s3 material').setAttribute('diffuseColor', '1 0 0');
    find(shown, '#t3').setAttribute('scale', '1 1 0.5');
    await drawn();
    await fall(shown);
    // Read, it is up to date, and x3dom's own.
    nodeOf(shown).getVolume();
    const { _trafo: matrix, _vf: fields } = nodeOf(shown);
    const { translation } = fields;
    const before = [matrix._13, translation!.y];
    await fall(shown);
    expect([matrix._13, translation!.y]).to.eql(before);
    expect(nodeOf(shown)._trafo._13).to.be.below(before[0]!);
    expect([nodeOf(shown)._trafo, nodeOf(shown)._vf]).to.eql([matrix, fields]);
    expect([matrix._13, translation!.y]).to.eql([translation!.y, translation!.y]);
  });

  it('tell who listens where they are', async () => {
    const shown = await showBatched(spun, 1);
    await fall(shown);
    const heard: number[] = [];
    find(shown, '#t3').addEventListener('transform', (event) =>
      heard.push((event as unknown as { worldY: number }).worldY),
    );
    await until(() => heard.length > 0);
    await fall(shown);
    const [, y] = shown.world.node('b3')!.get('position') as number[];
    expect(heard.at(-1)).to.equal(y);
    expect(draws(shown.x3d)).to.equal(1);
  });
});

/** What happens to one of them while all fall. */
const EVENTS: Record<string, (shown: Shown) => unknown> = {
  'it is drawn by itself': (shown) => find(shown, '#b3').setAttribute('batch', 'false'),
  'it gets another scale': (shown) => find(shown, '#t3').setAttribute('scale', '0.5 2 1'),
  'it gets another centre': (shown) => find(shown, '#t3').setAttribute('center', '0.5 0 0.2'),
  'it is put elsewhere': (shown) => find(shown, '#t3').setAttribute('translation', '0 3 0'),
  'what stands above it moves': (shown) =>
    find(shown, '#above').setAttribute('translation', '1 2 0'),
  'it is moved into another group': (shown) => find(shown, '#other').append(find(shown, '#t3')),
  'it has no body any more, and another takes its place': (shown) => {
    find(shown, '#b3').remove();
    find(shown, '#other').innerHTML =
      '<transform><shape><cone></cone></shape><x3d-rigid-body></x3d-rigid-body></transform>';
  },
  'it gets a body anew': async (shown) => {
    find(shown, '#b3').remove();
    await drawn();
    find(shown, '#t3').insertAdjacentHTML('beforeend', '<x3d-rigid-body></x3d-rigid-body>');
  },
  'a ClipPlane has all drawn one by one': (shown) =>
    find(shown, 'scene').insertAdjacentHTML(
      'afterbegin',
      '<clipplane plane="0 1 0 9"></clipplane>',
    ),
  'the world goes back to where it was': async (shown) => {
    const snapshot = shown.world.snapshot();
    await fall(shown);
    shown.world.restore(snapshot);
  },
};

describe('a body that falls, drawn with others,', () => {
  const scene = `<group id="other"></group>${SCENES[', under a Transform']}`;
  for (const [what, happen] of Object.entries(EVENTS))
    it(`stands where it would stand by itself when ${what}`, async () => {
      const [plain, together] = await bothWays(scene, async (shown) => {
        await fall(shown);
        await happen(shown);
        await drawn();
        const then = [nodeOf(shown)._trafo, runtimeOf(shown).getSceneBBox()];
        return { then: JSON.stringify(then), later: await findings(shown) };
      });
      expect(together).to.eql(plain);
    });
});
