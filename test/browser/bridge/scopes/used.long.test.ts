import { expect } from 'chai';
import { page } from '../../../../elements/bridge/index.js';
import { drawn, drawnAt, nextFrame, place, position, until } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';
import { claim } from '../../console.js';
import { fieldsOf, inAnotherCollection, isOwned, MOVABLE, PLACES, sceneWithout } from './used.js';

interface Seen {
  /** Where all bodies are after a second, by name. */
  at: Record<string, number[]>;
  counts: Record<string, number>[];
  problems: string[];
  /** How far above its floor the drawn shape of a body is when the body is there. */
  gaps: number[];
}

async function see(markup: string): Promise<Seen> {
  place(markup);
  // Until then the scene before it is there, too.
  await nextFrame();
  await until(() => ALL.every((name) => worldNamed(name)?.node(name) !== undefined), 1000);
  const worlds = ['collection', 'crateBody'].map((name) => worldNamed(name)!);
  for (const world of worlds) {
    await world.ready;
    world.paused = true;
    world.reset();
    world.advance(1);
  }
  await drawn();
  return {
    at: Object.fromEntries([
      ...['ball', 'arm', 'floor', 'post'].map((name) => [name, position(worlds[0], name)]),
      ['crateBody', position(worlds[1], 'crateBody')],
    ]),
    counts: worlds.map(({ stats: { bodies, joints } }) => ({ bodies, joints })),
    problems: worlds.flatMap((world) => world.problems.map(({ message }) => message)),
    gaps: ['ball', 'arm'].map((name) => gapOf(worlds[0], name)),
  };
}

function worldNamed(name: string): World | undefined {
  const element = page.find(name);
  return element && worldOf(element);
}

const ALL = ['collection', 'ball', 'arm', 'floor', 'post', 'crateBody'];

/** Between a body and what x3dom draws of its collidable. */
function gapOf(world: World, name: string): number {
  const [x, y, z] = position(world, name);
  const shape = page.find(`${name}Shape`)!;
  const [a, b, c] = drawnAt(shape);
  return Math.hypot(x - a, y - b, z - c);
}

const TOLERANCE = 1e-4;

function compare(seen: Seen, expected: Seen): void {
  expect(seen.problems).to.eql([]);
  expect(seen.counts).to.eql(expected.counts);
  for (const [name, at] of Object.entries(expected.at))
    at.forEach((value, i) =>
      expect(seen.at[name][i], `${name} ${i}`).to.be.closeTo(value, TOLERANCE),
    );
  for (const gap of seen.gaps) expect(gap).to.be.lessThan(0.01);
}

describe('a node that stands elsewhere and is USEd', () => {
  let expected: Seen;
  let cases = 0;
  const rows = Object.keys(PLACES).length;

  before(async () => {
    expected = await see(sceneWithout(undefined).scene);
  });

  for (const [where, put] of Object.entries(PLACES)) {
    for (const moved of MOVABLE) {
      it(`${moved} in ${where} is ${fieldsOf(moved).join(', ')} as if it stood there`, async () => {
        const { scene, node } = sceneWithout(moved);
        compare(await see(put(scene, node)), expected);
        cases++;
      });
    }
  }

  for (const moved of MOVABLE) {
    if (moved === 'collection') continue;
    it(`${moved} in another collection after it is ${fieldsOf(moved).join(', ')} as if it stood there`, async () => {
      const { scene, node } = sceneWithout(moved);
      if (isOwned(moved)) claim('already-owned');
      const seen = await see(inAnotherCollection(scene, node));
      if (isOwned(moved)) expect(seen.problems.splice(0).length).to.equal(1);
      compare(seen, expected);
    });
  }

  it('none of the places and fields is left out', () => {
    expect(cases).to.equal(rows * MOVABLE.length);
  });
});
