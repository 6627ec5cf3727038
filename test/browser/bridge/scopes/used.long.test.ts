import { expect } from 'chai';
import { page } from '../../../../elements/bridge/index.js';
import { drawn, drawnAt, nextFrame, place, position, until } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';
import { claim } from '../../console.js';
import { ALL, fieldsOf, MOVED, ownedAmong, PLACES, sceneWithout } from './used.js';

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
  await until(() => NAMED.every((name) => worldNamed(name)?.node(name) !== undefined));
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

const NAMED = ['collection', 'ball', 'arm', 'floor', 'post', 'crateBody'];

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

describe('nodes that stand elsewhere and are USEd', () => {
  let expected: Seen;
  const walked = new Set<string>();

  // x3dom itself stumbles over an Inline that goes within a second of its coming.
  const { setTimeout } = window;
  after(() => (window.setTimeout = setTimeout));

  before(async () => {
    const soon = (work: TimerHandler, delay?: number): number =>
      setTimeout(work, delay === 1000 ? 0 : delay);
    window.setTimeout = soon as typeof window.setTimeout;
    expected = await see(sceneWithout([]).scene);
  });

  for (const [where, put] of Object.entries(PLACES)) {
    for (const moved of MOVED) {
      it(`${moved.join(', ')} in ${where} are as if they stood there`, async () => {
        const { scene, kept } = sceneWithout(moved);
        const owned = where === 'another collection after' ? ownedAmong(moved) : 0;
        claim(...Array<string>(owned).fill('already-owned'));
        const seen = await see(put(scene, kept));
        expect(seen.problems.splice(0)).to.have.lengthOf(owned);
        compare(seen, expected);
        for (const def of moved)
          for (const field of fieldsOf(def)) walked.add(`${where}: ${def} as ${field}`);
      });
    }
  }

  it('none of the places, nodes and fields is left out', () => {
    const values = ALL.flatMap(fieldsOf).length;
    expect(MOVED.flat().sort()).to.eql([...ALL].sort());
    expect(walked.size).to.equal(Object.keys(PLACES).length * values);
  });
});
