import { expect } from 'chai';
import { worldOf, type World } from '../../inside.js';
import { codes, drawn, show } from '../../scene.js';

type System = Element & { positions: number[][]; emitter: Element | null; count: number };

const FIELDS =
  'maxparticles="10" particlelifetime="1" lifetimevariation="0" particlesize="0.2 0.4"';
const UP = 'direction="0 1 0" speed="1" variation="0" mass="1"';
const EMITTER = `<x3d-point-emitter def="E" id="e" ${UP}></x3d-point-emitter>`;
const SHARED = '<x3d-point-emitter use="E"></x3d-point-emitter>';

const system = (id: string, inside: string): string =>
  `<x3d-particle-system id="${id}" ${FIELDS}>${inside}</x3d-particle-system>`;

/** Two systems, the second of which stands at x = 5 and is turned: what goes up there goes along x. */
const twoOf = (first: string, second: string): string =>
  `<x3d-rigid-body-collection id="c" rest="never"></x3d-rigid-body-collection>${system('s1', first)}
   <transform id="t" translation="5 0 0" rotation="0 0 1 -1.5707963267948966">${system('s2', second)}</transform>`;

async function shown(content: string): Promise<{ x3d: Element; world: World; systems: System[] }> {
  const { x3d, world } = await show(content, '#c');
  world.paused = true;
  world.reset();
  return { x3d, world, systems: ['s1', 's2'].map((id) => x3d.querySelector<System>(`#${id}`)!) };
}

const near = (actual: number[], expected: number[]): void =>
  actual.forEach((value, i) => expect(value).to.be.closeTo(expected[i]!, 1e-6));

/** Where the oldest of each is. */
const oldest = (systems: System[], expected: number[][]): void =>
  systems.forEach(({ positions }, i) => near(positions[0]!, expected[i]!));

describe('an emitter or a model that two systems share', () => {
  it('is in each where that stands', async () => {
    const { world, systems } = await shown(twoOf(EMITTER, SHARED));
    world.advance(0.5);
    oldest(systems, [
      [0, 0.5, 0],
      [5.5, 0, 0],
    ]);
    const e = document.getElementById('e');
    for (const each of systems) expect(each.emitter === e).to.be.true;
    expect(world.node('E')!.get('position')).to.eql([0, 0, 0]);
    expect(codes(world)).to.eql([]);
  });

  it('reaches both with each edit: of an attribute, a property, an event, a Transform', async () => {
    const { x3d, world, systems } = await shown(twoOf(EMITTER, SHARED));
    const e = x3d.querySelector('#e')! as Element & {
      position: number[];
      setFieldValue?(name: string, value: unknown): void;
    };
    e.setAttribute('speed', '2');
    e.position = [0, 1, 0];
    await drawn();
    world.reset();
    world.advance(0.25);
    oldest(systems, [
      [0, 1.5, 0],
      [6.5, 0, 0],
    ]);
    e.removeAttribute('speed');
    x3d.querySelector('#t')!.setAttribute('rotation', '0 0 1 0');
    await drawn();
    world.reset();
    world.advance(0.25);
    oldest(systems, [
      [0, 1, 0],
      [5, 1, 0],
    ]);
    expect(codes(world)).to.eql([]);
  });

  it('a force acts along its own direction in each, and a wall stands where its system does', async () => {
    const force = '<x3d-force-physics-model def="F" force="0 4 0"></x3d-force-physics-model>';
    const wall =
      '<x3d-bounded-physics-model def="W"><box size="1 1 1"></box></x3d-bounded-physics-model>';
    const { world, systems } = await shown(
      twoOf(
        `${EMITTER}${force}`,
        `${SHARED}<x3d-force-physics-model use="F"></x3d-force-physics-model>`,
      ),
    );
    world.advance(0.5);
    oldest(systems, [
      [0, 1, 0],
      [6, 0, 0],
    ]);
    const walled = await shown(
      twoOf(
        `${EMITTER}${wall}`,
        `${SHARED}<x3d-bounded-physics-model use="W"></x3d-bounded-physics-model>`,
      ),
    );
    walled.world.advance(0.9);
    for (const [, y] of walled.systems[0]!.positions) expect(y).to.be.below(0.5);
    for (const [x] of walled.systems[1]!.positions) expect(x).to.be.below(5.5);
    expect(walled.systems[1]!.count).to.be.above(5);
  });

  it('serves systems in two worlds', async () => {
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c" rest="never">${system('s1', EMITTER)}</x3d-rigid-body-collection>
       <x3d-rigid-body-collection id="d" rest="never">${system('s2', SHARED)}</x3d-rigid-body-collection>`,
      '#c',
    );
    const other = worldOf(x3d.querySelector('#d')!)!;
    expect(other).not.to.equal(world);
    for (const each of [world, other]) {
      each.paused = true;
      each.reset();
      each.advance(0.5);
    }
    const systems = ['s1', 's2'].map((id) => x3d.querySelector<System>(`#${id}`)!);
    oldest(systems, [
      [0, 0.5, 0],
      [0, 0.5, 0],
    ]);
    expect(codes(world)).to.eql([]);
    expect(codes(other)).to.eql([]);
  });

  it('leaves nothing behind: where either goes the other goes on', async () => {
    for (const goes of [0, 1]) {
      const { world, systems } = await shown(twoOf(EMITTER, SHARED));
      const emitters = (): number => world.stats.created - world.stats.destroyed;
      const before = emitters();
      const [gone, stays] = [systems[goes]!, systems[1 - goes]!];
      // What is shared is to outlive the system that it stands in.
      if (goes === 0) gone.parentElement!.append(gone.querySelector('#e')!);
      gone.remove();
      await drawn();
      world.reset();
      world.advance(0.5);
      oldest([stays], [goes === 0 ? [5.5, 0, 0] : [0, 0.5, 0]]);
      // The system, and the node that it had for itself.
      expect(before - emitters()).to.equal(2);
      expect(codes(world)).to.eql([]);
    }
  });
});
