import { expect } from 'chai';
import { claim } from '../../console.js';
import { place, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

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
      claim('unknown-attribute');
      const { world } = await show(inWorld(`<${tag} linearvelocty="1 0 0"></${tag}>`), '#c');
      expect(
        world.problems.map(({ code, message }) => [code, /linearVelocity\?$/.test(message)]),
      ).to.eql([['unknown-attribute', true]]);
    });

    it(`${tag}: values that can't be used keep the last valid one`, async () => {
      claim('mass="heavy" is', 'linearDampingFactor="3" is', 'mass="x" is');
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
    claim('bad-value');
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
    claim('self-closing');
    expect(await codes(`<x3d-rigid-body fixed="true" /><x3d-rigid-body></x3d-rigid-body>`)).to.eql([
      'self-closing',
    ]);
  });

  it('a node of x3dom that swallowed bodies', async () => {
    claim('<viewpoint> has swallowed <x3d-rigid-body>');
    const heard: string[] = [];
    const listen = (event: Event): void =>
      void heard.push(
        `${(event.target as Element).localName} ${(event as CustomEvent).detail.code}`,
      );
    document.addEventListener('physicsproblem', listen);
    place(
      '<viewpoint position="0 2 8" /><transform><shape><box></box></shape><x3d-rigid-body></x3d-rigid-body></transform>',
    );
    await until(() => heard.length > 0);
    document.removeEventListener('physicsproblem', listen);
    expect(heard).to.eql(['viewpoint self-closing']);
  });

  it('a Transform in a collection, which nothing draws', async () => {
    claim('nothing draws <transform> in RigidBodyCollection "c"');
    expect(
      await codes(
        `<transform><shape><box></box></shape><x3d-rigid-body></x3d-rigid-body></transform>`,
      ),
    ).to.eql(['misplaced']);
  });

  it('a Transform in a body', async () => {
    claim('put the body into the Transform');
    expect(await codes(`<x3d-rigid-body><transform></transform></x3d-rigid-body>`)).to.eql([
      'misplaced',
    ]);
  });

  it('a Shape directly in a body', async () => {
    claim('misplaced');
    expect(await codes(`<x3d-rigid-body><shape><sphere></sphere></shape></x3d-rigid-body>`)).to.eql(
      ['misplaced'],
    );
  });

  it('a Shape whose geometry has not come yet', async () => {
    claim('waiting-for-geometry');
    const { x3d, world } = await show(
      inWorld(
        `<x3d-rigid-body id="a"><x3d-collidable-shape id="s"><shape></shape></x3d-collidable-shape></x3d-rigid-body>`,
      ),
      '#c',
    );
    expect(world.problems.map(({ code }) => code)).to.eql(['waiting-for-geometry']);
    x3d.querySelector('shape')!.innerHTML = '<sphere radius="2"></sphere>';
    await until(() => world.problems.length === 0);
    expect((world.node('s')!.get('shape') as { radius: number }[])[0].radius).to.equal(2);
  });

  it('outside any x3d, and in a shadow root', async () => {
    claim('misplaced', 'shadow-root');
    const heard: string[] = [];
    const listen = (event: Event): void => void heard.push((event as CustomEvent).detail.code);
    document.addEventListener('physicsproblem', listen);
    document.body.innerHTML = '<x3d-rigid-body></x3d-rigid-body><div id="host"></div>';
    const root = document.querySelector('#host')!.attachShadow({ mode: 'open' });
    root.innerHTML = '<x3d><scene><x3d-rigid-body></x3d-rigid-body></scene></x3d>';
    await until(() => heard.length > 1);
    document.removeEventListener('physicsproblem', listen);
    expect(heard).to.eql(['misplaced', 'shadow-root']);
  });

  it('an element set up before it is defined and attached keeps what was set', async () => {
    claim('position="4 5" is');
    const body = document.createElement('x3d-rigid-body');
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

describe('a problem of the markup', () => {
  it('stands while its cause does, and is said once', async () => {
    claim('"gone"', '"nobody"');
    const { x3d, world } = await show(
      inWorld(`
        <x3d-rigid-body id="a"><x3d-collidable-shape use="gone"></x3d-collidable-shape></x3d-rigid-body>
        <x3d-ball-joint id="j" body1="a"></x3d-ball-joint>`),
      '#c',
    );
    world.paused = true;
    const codes = (): unknown[] => {
      world.step(0);
      return world.problems.map(({ code, value }) => [code, value]);
    };
    expect(codes()).to.eql([['unknown-reference', 'gone']]);
    // The body takes a shape that is there: the other one still is not.
    x3d
      .querySelector('#a')!
      .insertAdjacentHTML(
        'beforeend',
        '<x3d-collidable-shape><shape><sphere></sphere></shape></x3d-collidable-shape>',
      );
    expect(codes()).to.eql([['unknown-reference', 'gone']]);
    // Without its second body the joint is taken out of the world; why, stays to be seen.
    x3d.querySelector('#j')!.setAttribute('body2', 'nobody');
    expect(codes()).to.have.deep.members([
      ['unknown-reference', 'gone'],
      ['unknown-reference', 'nobody'],
    ]);
    expect(world.stats.joints).to.equal(0);
    x3d.querySelector('#j')!.remove();
    x3d.querySelector('[use]')!.remove();
    expect(codes()).to.eql([]);
    expect(x3d.querySelector('#a')!.matches(':state(problem)')).to.equal(false);
  });
});

/** Markup that is wrong, and the problem that it gets. */
const wrong: [title: string, markup: string, code: string, words?: string][] = [
  [
    'a DEF that is nowhere',
    '<x3d-rigid-body id="w"><x3d-collidable-shape use="gone"></x3d-collidable-shape></x3d-rigid-body>',
    'unknown-reference',
    '"gone"',
  ],
  [
    'a joint naming nobody',
    '<x3d-rigid-body id="w" fixed="true"></x3d-rigid-body><x3d-ball-joint body1="w" body2="nobody"></x3d-ball-joint>',
    'unknown-reference',
    '"nobody"',
  ],
  ['a joint without bodies', '<x3d-ball-joint anchorPoint="0 1 0"></x3d-ball-joint>', 'no-body'],
  [
    'a wrong number',
    '<x3d-rigid-body id="w" position="1 two 3" fixed="true"></x3d-rigid-body>',
    'bad-value',
    'position="1 two 3"',
  ],
  [
    'a number out of range',
    '<x3d-rigid-body id="w" angularDampingFactor="-2" fixed="true"></x3d-rigid-body>',
    'out-of-range',
    '0 is used',
  ],
  [
    'a wrong number in a geometry',
    '<x3d-rigid-body id="w" fixed="true"><x3d-collidable-shape><shape><box size="1 x 1"></box></shape></x3d-collidable-shape></x3d-rigid-body>',
    'bad-value',
    'size="1 x 1"',
  ],
  [
    'a box of no size',
    '<x3d-rigid-body id="w" fixed="true"><x3d-collidable-shape><shape><box size="0 0 0"></box></shape></x3d-collidable-shape></x3d-rigid-body>',
    'zero-volume',
  ],
  [
    'a cylinder of no height',
    '<x3d-rigid-body id="w" fixed="true"><x3d-collidable-shape><shape><cylinder height="0"></cylinder></shape></x3d-collidable-shape></x3d-rigid-body>',
    'zero-volume',
  ],
  [
    'a self-closed tag',
    '<x3d-rigid-body id="w" fixed="true" /><x3d-rigid-body id="x" fixed="true" />',
    'self-closing',
  ],
];
const plain = (markup: string): string =>
  markup
    .replaceAll('x3d-rigid-body', 'RigidBody')
    .replaceAll('x3d-collidable-shape', 'CollidableShape')
    .replaceAll('x3d-ball-joint', 'BallJoint');

describe('a malformed page', () => {
  for (const [title, markup, code, words] of wrong) {
    for (const content of [markup, plain(markup)]) {
      it(`${content === markup ? 'custom' : 'plain'} tags, ${title}: one problem, and the rest goes on`, async () => {
        claim(words ?? code);
        const heard: string[] = [];
        const listen = (event: Event): void => void heard.push((event as CustomEvent).detail.code);
        document.addEventListener('physicsproblem', listen);
        const good = '<x3d-rigid-body id="good" position="9 3 0"></x3d-rigid-body>';
        const { world } = await show(inWorld(good + content), '#c');
        world.paused = true;
        await wait(30);
        // Later changes elsewhere say nothing anew.
        document
          .querySelector('#c')!
          .insertAdjacentHTML('beforeend', good.replace('good', 'late').replace('9', '12'));
        const speed = (name: string): number =>
          (world.node(name)!.get('linearVelocity') as number[])[1]!;
        world.step(0);
        const before = [speed('good'), speed('late')];
        world.advance(1);
        document.removeEventListener('physicsproblem', listen);
        expect(heard).to.eql([code]);
        expect(world.problems.map((problem) => problem.code)).to.eql([code]);
        expect(speed('good') - before[0]!).to.be.closeTo(-9.8, 0.01);
        expect(speed('late') - before[1]!).to.be.closeTo(-9.8, 0.01);
      });
    }
  }
});

describe('what stands in no collection and has nobody', () => {
  const alone: [markup: string, code: string][] = [
    ['<BallJoint></BallJoint>', 'no-body'],
    ['<x3d-slider-joint></x3d-slider-joint>', 'no-body'],
  ];
  for (const [markup, code] of alone)
    it(`is told, though nothing else has physics: ${markup}`, async () => {
      claim(code);
      const page = place(markup);
      const element = page.querySelector('scene')!.firstElementChild!;
      await until(() => worldOf(element) !== undefined);
      const world = await worldOf(element)!.ready;
      await until(() => world.problems.length > 0);
      expect(world.problems.map((problem) => problem.code)).to.eql([code]);
    });
});
