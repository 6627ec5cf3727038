import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../elements/index.js';
import { bothSpellings } from '../../forms.js';
import { show, wait } from '../../scene.js';

type Named = 'beforestep' | 'afterstep' | 'sleep' | 'wake';

const bodies = bothSpellings(`
  <group id="g"><x3d-rigid-body-collection id="c" disabletime="0.1" disablelinearspeed="1" disableangularspeed="1">
    <x3d-rigid-body id="b" autodisable="true" useglobalgravity="false"></x3d-rigid-body>
    <x3d-rigid-body id="other"></x3d-rigid-body>
  </x3d-rigid-body-collection></group>`);

async function paused(markup: string) {
  const shown = await show(markup, '#c');
  shown.world.paused = true;
  return shown;
}

describe('beforestep and afterstep', () => {
  for (const [spelling, markup] of bodies) {
    for (const where of ['#c', '#g', 'x3d', 'document', 'window']) {
      it(`${spelling} tags: fire once per step for who listens at ${where}, and are not made for nobody`, async () => {
        const { x3d, world } = await paused(markup);
        const target =
          where === 'window'
            ? window
            : where === 'document'
              ? document
              : document.querySelector(where)!;
        const heard: string[] = [];
        const note = (event: Event): void => void heard.push(event.type);
        const names: Named[] = ['beforestep', 'afterstep'];
        expect(names.map((name) => world.heard(name))).to.eql([false, false]);
        for (const name of names) target.addEventListener(name, note);
        expect(names.map((name) => world.heard(name))).to.eql([true, true]);
        world.step(2);
        expect(heard).to.eql(['beforestep', 'afterstep', 'beforestep', 'afterstep']);
        for (const name of names) target.removeEventListener(name, note);
        expect(names.map((name) => world.heard(name))).to.eql([false, false]);
        world.step(1);
        expect(heard.length).to.equal(4);
        expect(x3d.isConnected).to.equal(true);
      });
    }
  }
});

describe('who listens', () => {
  const [[, markup]] = bodies;

  it('once is once, a signal ends it, capture and bubbling are two, the same twice is one', async () => {
    const { x3d, world } = await paused(markup);
    const target = x3d.querySelector('#c')!;
    let calls = 0;
    const note = (): void => void calls++;
    target.addEventListener('afterstep', note, { once: true });
    expect(world.heard('afterstep')).to.equal(true);
    world.step(1);
    expect([calls, world.heard('afterstep')]).to.eql([1, false]);

    const control = new AbortController();
    target.addEventListener('afterstep', note, { signal: control.signal });
    expect(world.heard('afterstep')).to.equal(true);
    control.abort();
    expect(world.heard('afterstep')).to.equal(false);
    target.addEventListener('afterstep', note, { signal: control.signal });
    expect(world.heard('afterstep')).to.equal(false);

    target.addEventListener('afterstep', note, true);
    target.addEventListener('afterstep', note);
    target.addEventListener('afterstep', note, { passive: true });
    target.removeEventListener('afterstep', note);
    expect(world.heard('afterstep')).to.equal(true);
    world.step(1);
    expect(calls).to.equal(2);
    target.removeEventListener('afterstep', note, { capture: true });
    expect(world.heard('afterstep')).to.equal(false);
  });

  it('a listener object, one that is not there and one removed unheard are taken as the platform takes them', async () => {
    const { x3d, world } = await paused(markup);
    let calls = 0;
    const object = { handleEvent: (): void => void calls++ };
    x3d.addEventListener('beforestep', null as never);
    x3d.removeEventListener('beforestep', object);
    expect(world.heard('beforestep')).to.equal(false);
    x3d.addEventListener('beforestep', object, { once: true });
    x3d.removeEventListener('beforestep', object);
    expect(world.heard('beforestep')).to.equal(false);
    x3d.addEventListener('beforestep', object);
    world.step(1);
    expect(calls).to.equal(1);
  });

  it('a listener elsewhere in the page is nobody', async () => {
    const { world } = await paused(markup);
    const aside = document.createElement('p');
    document.body.append(aside);
    const note = (): void => {};
    aside.addEventListener('beforestep', note);
    expect(world.heard('beforestep')).to.equal(false);
    aside.remove();
  });

  it('x3dom hands its elements over to us: a listener at a Transform is heard', async () => {
    const { x3d, world } = await paused(
      '<transform id="t"><x3d-rigid-body-collection id="c"><x3d-rigid-body></x3d-rigid-body></x3d-rigid-body-collection></transform>',
    );
    const at = x3d.querySelector('#t')!;
    expect(Object.hasOwn(at, '__addEventListener')).to.equal(true);
    let calls = 0;
    const note = (): void => void calls++;
    at.addEventListener('afterstep', note);
    world.step(1);
    at.removeEventListener('afterstep', note);
    world.step(1);
    expect([calls, world.heard('afterstep')]).to.eql([1, false]);
  });
});

describe('sleep and wake', () => {
  for (const [spelling, markup] of bodies) {
    it(`${spelling} tags: fire once each at the body, with nothing said of another`, async () => {
      const { x3d, world } = await paused(markup);
      const heard: string[] = [];
      for (const name of ['sleep', 'wake'])
        x3d.addEventListener(name, (event) =>
          heard.push(`${event.type} ${(event.target as Element).id}`),
        );
      world.advance(0.05);
      expect(heard).to.eql([]);
      world.advance(0.5);
      expect(heard).to.eql(['sleep b']);
      x3d.querySelector('#b')!.setAttribute('linearvelocity', '2 0 0');
      world.step(2);
      expect(heard).to.eql(['sleep b', 'wake b']);
    });
  }

  it('show as a state of custom elements', async () => {
    const { x3d, world } = await paused(bodies[0]![1]);
    const body = x3d.querySelector<X3DRigidBodyElement>('#b')!;
    expect(body.matches(':state(sleeping)')).to.equal(false);
    world.advance(0.5);
    expect(body.matches(':state(sleeping)')).to.equal(true);
    expect(x3d.querySelector('#other')!.matches(':state(sleeping)')).to.equal(false);
    body.wake();
    world.step(1);
    expect(body.matches(':state(sleeping)')).to.equal(false);
    await wait(0);
  });
});

describe('jointlimit', () => {
  const joints: [string, string, string, string][] = [
    ['x3d-single-axis-hinge-joint', 'axis="0 0 1" maxangle="0.5"', 'angularvelocity', '0 0 2'],
    [
      'x3d-double-axis-hinge-joint',
      'axis1="0 0 1" axis2="1 0 0" maxangle1="0.5"',
      'angularvelocity',
      '0 0 2',
    ],
    [
      'x3d-slider-joint',
      'axis="1 0 0" minseparation="-1" maxseparation="0.5"',
      'linearvelocity',
      '2 0 0',
    ],
  ];
  for (const [tag, attributes, field, value] of joints)
    for (const [spelling, markup] of bothSpellings(`
      <x3d-rigid-body-collection id="c" gravity="0 0 0">
        <x3d-rigid-body id="b"></x3d-rigid-body>
        <${tag} id="j" body1="b" ${attributes}></${tag}>
      </x3d-rigid-body-collection>`))
      it(`${tag}, ${spelling} tag: fires once when the stop is reached, not before and not for nobody`, async () => {
        const { x3d, world } = await paused(markup);
        x3d.querySelector('#b')!.setAttribute(field, value);
        const heard: string[] = [];
        const note = (event: Event): void =>
          void heard.push(`${(event.target as Element).id} ${(event as CustomEvent).detail.limit}`);
        const node = world.node('j') as unknown as { heard(name: string): boolean };
        expect(node.heard('jointlimit')).to.equal(false);
        x3d.addEventListener('jointlimit', note);
        expect(node.heard('jointlimit')).to.equal(true);
        world.advance(0.15);
        expect(heard).to.eql([]);
        world.advance(0.5);
        expect(heard).to.eql(['j max']);
        x3d.removeEventListener('jointlimit', note);
        expect(node.heard('jointlimit')).to.equal(false);
      });
});
