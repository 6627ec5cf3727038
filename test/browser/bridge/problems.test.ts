import { expect } from 'chai';
import { worldOf } from '../../../elements/index.js';
import { place, show, wait } from './scene.js';

const inWorld = (content: string): string =>
  `<x3d-rigid-body-collection id="c">${content}</x3d-rigid-body-collection>`;

async function codes(content: string): Promise<string[]> {
  const { world } = await show(inWorld(content), '#c');
  world.paused = true;
  await wait(30);
  return world.problems.map(({ code, attribute }) => (attribute ? `${code} ${attribute}` : code));
}

describe('problems', () => {
  it('a clean scene has none', async () => {
    const clean = `<x3d-rigid-body id="a" mass="2" class="x" data-y="1"><x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape></x3d-rigid-body>`;
    expect(await codes(clean)).to.eql([]);
    expect(
      await codes(
        clean
          .replaceAll('x3d-rigid-body', 'RigidBody')
          .replaceAll('x3d-collidable-shape', 'CollidableShape'),
      ),
    ).to.eql([]);
  });

  for (const tag of ['x3d-rigid-body', 'RigidBody']) {
    it(`${tag}: unknown attributes, with what was meant`, async () => {
      const { world } = await show(inWorld(`<${tag} linearvelocty="1 0 0"></${tag}>`), '#c');
      expect(
        world.problems.map(({ code, message }) => [code, /linearVelocity\?$/.test(message)]),
      ).to.eql([['unknown-attribute', true]]);
    });

    it(`${tag}: values that can't be used keep the last valid one`, async () => {
      const { x3d, world } = await show(
        inWorld(`<${tag} id="a" mass="heavy" linearDampingFactor="3"></${tag}>`),
        '#c',
      );
      const node = world.node('a')!;
      expect(
        world.problems.map(({ code, attribute, value }) => [code, attribute, value]),
      ).to.deep.include.members([
        ['bad-value', 'mass', 'heavy'],
        ['out-of-range', 'linearDampingFactor', 3],
      ]);
      expect([node.get('mass'), node.get('linearDampingFactor')]).to.eql([1, 1]);
      const body = x3d.querySelector('#a')!;
      body.setAttribute('mass', '4');
      world.step(0);
      expect(node.get('mass')).to.equal(4);
      body.setAttribute('mass', 'x');
      world.step(0);
      expect(node.get('mass')).to.equal(4);
      body.removeAttribute('mass');
      world.step(0);
      expect(node.get('mass')).to.equal(1);
      expect(world.problems.filter(({ attribute }) => attribute === 'mass')).to.eql([]);
    });
  }

  it('fire at the element, bubble, and show as a state', async () => {
    const heard: string[] = [];
    const listen = (event: Event): void =>
      void heard.push(`${(event.target as Element).id} ${(event as CustomEvent).detail.code}`);
    document.addEventListener('physicsproblem', listen);
    const { x3d } = await show(inWorld(`<x3d-rigid-body id="a" mass="x"></x3d-rigid-body>`), '#c');
    document.removeEventListener('physicsproblem', listen);
    expect(heard).to.eql(['a bad-value']);
    expect(x3d.querySelector('#a')!.matches(':state(problem)')).to.equal(true);
  });

  it('a self-closed tag that swallowed its siblings', async () => {
    expect(await codes(`<x3d-rigid-body fixed="true" /><x3d-rigid-body></x3d-rigid-body>`)).to.eql([
      'self-closing',
    ]);
  });

  it('a Shape directly in a body', async () => {
    expect(await codes(`<x3d-rigid-body><shape><sphere></sphere></shape></x3d-rigid-body>`)).to.eql(
      ['misplaced'],
    );
  });

  it('a Shape whose geometry has not come yet', async () => {
    const { x3d, world } = await show(
      inWorld(
        `<x3d-rigid-body id="a"><x3d-collidable-shape id="s"><shape></shape></x3d-collidable-shape></x3d-rigid-body>`,
      ),
      '#c',
    );
    expect(world.problems.map(({ code }) => code)).to.eql(['waiting-for-geometry']);
    x3d.querySelector('shape')!.innerHTML = '<sphere radius="2"></sphere>';
    await wait(30);
    expect(world.problems).to.eql([]);
    expect((world.node('s')!.get('shape') as { radius: number }[])[0].radius).to.equal(2);
  });

  it('outside any x3d, and in a shadow root', async () => {
    const heard: string[] = [];
    const listen = (event: Event): void => void heard.push((event as CustomEvent).detail.code);
    document.addEventListener('physicsproblem', listen);
    document.body.innerHTML = '<x3d-rigid-body></x3d-rigid-body><div id="host"></div>';
    const root = document.querySelector('#host')!.attachShadow({ mode: 'open' });
    root.innerHTML = '<x3d><scene><x3d-rigid-body></x3d-rigid-body></scene></x3d>';
    await wait(20);
    document.removeEventListener('physicsproblem', listen);
    expect(heard).to.eql(['misplaced', 'shadow-root']);
  });

  it('an element set up before it is defined and attached keeps what was set', async () => {
    const body = document.createElement('x3d-rigid-body') as unknown as HTMLElement & {
      mass: unknown;
      position: unknown;
    };
    body.mass = 5;
    body.position = new Float32Array([1, 2, 3]);
    expect(body.position).to.eql([1, 2, 3]);
    const x3d = place(inWorld(''));
    x3d.querySelector('#c')!.append(body);
    const world = worldOf(body)!;
    await world.ready;
    world.paused = true;
    expect([body.mass, world.node(body)!.get('mass')]).to.eql([5, 5]);
    body.position = '4 5 6';
    expect(body.position).to.eql([4, 5, 6]);
    body.position = [4, 5];
    expect(body.position).to.eql([4, 5, 6]);
    expect(world.problems.map(({ code }) => code)).to.eql(['bad-value']);
  });
});
