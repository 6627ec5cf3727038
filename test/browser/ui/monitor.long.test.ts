import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../elements/index.js';
import { claim } from '../console.js';
import { drawn, drawnAt, show, until } from '../scene.js';
import { addMonitor, Shown, TWO_SCENES } from './monitor.js';
import { worldOf } from '../inside.js';

const falling = `<x3d-rigid-body-collection id="collection">
    <x3d-rigid-body id="ball" def="ball" for="shape"></x3d-rigid-body>
  </x3d-rigid-body-collection>
  <transform id="shape"><shape><sphere></sphere></shape></transform>`;

/** Two boxes that swing on each other: a millimetre apart after a second of `game`. */
const swinging = `<x3d-rigid-body-collection>
    <x3d-rigid-body id="ball" def="ball" for="shape"></x3d-rigid-body>
    <x3d-rigid-body id="other" for="second"></x3d-rigid-body>
    <x3d-ball-joint body1="ball" anchorpoint="0 9 0"></x3d-ball-joint>
    <x3d-ball-joint body1="ball" body2="other" anchorpoint="2 9 0"></x3d-ball-joint>
  </x3d-rigid-body-collection>
  <transform id="shape" translation="2 9 0"><shape><box size=".4 .4 .4"></box></shape></transform>
  <transform id="second" translation="4 9.5 0"><shape><box size=".4 .4 .4"></box></shape></transform>`;

const monitorEffect = (world: ReturnType<typeof worldOf>) =>
  world!.effects.find(({ name }) => name === 'monitor')!;

async function started(): Promise<void> {
  document.body.innerHTML = TWO_SCENES;
  for (const id of ['first', 'second'])
    await worldOf(document.getElementById(id)!.querySelector('x3d-rigid-body'))!.ready;
}

describe('the monitor', () => {
  it('shows the world of an x3d, a collection, or a body by its DEF', async () => {
    await started();
    const shown = addMonitor();
    for (const [name, bodies] of [
      ['first', '1'],
      ['collection', '2'],
      ['single', '1'],
      ['b', '2'],
    ] as const) {
      shown.monitor.for = name;
      await shown.shows('Bodies', bodies);
      expect(shown.monitor.getAttribute('for')).to.equal(name);
    }
  });

  it('records, looks back by its slider, and goes on from there', async () => {
    const { world } = await show(falling);
    const height = (): number => drawnAt(document.getElementById('shape')!)[1]!;
    world.paused = true;
    const shown = addMonitor('for="ball"');
    await until(() => shown.button(/Record/) !== undefined && !shown.button(/Record/).disabled);
    const first = world.time;
    shown.button(/Record/).click();
    await until(() => world.timeline !== undefined);
    world.step(120);
    await drawn();
    const end = height();
    await until(() => shown.root.querySelector('input[type=range]') !== null);
    const slider = shown.root.querySelector<HTMLInputElement>('input[type=range]')!;
    await until(() => Number(slider.max) > first + 0.9);
    slider.value = String(first + 0.5);
    slider.dispatchEvent(new Event('input'));
    await until(() => shown.text.includes('Looking back'));
    await until(() => height() > end + 1);
    expect(world.time).to.be.closeTo(first + 1, 1e-9);
    shown.button(/Go on from here/).click();
    expect(world.time).to.be.closeTo(first + 0.5, 0.02);
    expect(height()).to.be.above(end + 1);
    world.timeline!.play();
    await until(() => world.timeline!.at === world.timeline!.to && !world.timeline!.playing);
    shown.button(/Stop recording/).click();
    expect(world.timeline).to.equal(undefined);
  });

  it('has a ghost of the run at another level beside its slider, and says how far apart they are', async () => {
    const { world } = await show(swinging);
    world.paused = true;
    const shown = addMonitor('for="ball"');
    await until(() => shown.button(/Record/) !== undefined && !shown.button(/Record/).disabled);
    expect(shown.select('Ghost')).to.equal(undefined);
    shown.button(/Record/).click();
    await until(() => world.timeline !== undefined);
    world.step(120);
    await until(() => shown.select('Ghost') !== undefined);
    const select = shown.select('Ghost')!;
    expect([...select.options].map(({ value }) => value)).to.eql([
      '',
      'game',
      'fine',
      'precise',
      'reference',
    ]);
    expect(select.tabIndex).to.equal(0);
    expect(shown.text).to.not.contain('apart');
    select.focus();
    select.value = 'game';
    select.dispatchEvent(new Event('change'));
    await until(() => shown.text.includes('Look back to see it.'));
    const slider = shown.root.querySelector<HTMLInputElement>('input[type=range]')!;
    const seek = (time: number): void => {
      slider.value = String(time);
      slider.dispatchEvent(new Event('input'));
    };
    await until(() => Number(slider.max) > 0.9);
    seek(Number(slider.max));
    await until(() => /Farthest apart: [\d.]+ mm/.test(shown.text));
    expect(slider.getAttribute('aria-valuetext')).to.match(/, the ghost [\d.]+ mm away$/);
    expect(shown.root.activeElement).to.equal(select);
    // Of the colours it has that of the ghost alone.
    await until(() => shown.part('legend')?.children.length === 1);
    expect(shown.part('legend')!.textContent).to.contain('ghost');
    seek(0);
    await until(() => shown.text.includes('Farthest apart: 0'));
    world.set('debug', true);
    world.step(0);
    await until(() => (shown.part('legend')?.children.length ?? 0) > 5);
    world.set('debug', false);
    world.step(0);
    select.value = '';
    select.dispatchEvent(new Event('change'));
    await until(() => !shown.text.includes('apart'));
    expect(world.timeline!.ghostLevel).to.equal(undefined);
    await until(() => !shown.part('legend'));
    world.timeline!.stop();
  });

  it('without for shows the nearest x3d', async () => {
    await started();
    const inner = addMonitor('', document.getElementById('two')!);
    const outer = addMonitor();
    await inner.shows('Bodies', '2');
    await outer.shows('Bodies', '1');
  });

  it('waits for a target that comes late, and follows one that goes and comes again', async () => {
    document.body.innerHTML = '';
    const shown = addMonitor('for="collection"');
    await until(() => shown.text.includes('no physics at "collection" yet'));
    document.body.insertAdjacentHTML('afterbegin', TWO_SCENES);
    await shown.shows('Bodies', '2');
    const second = document.getElementById('second')!;
    const before = worldOf(second);
    second.remove();
    await until(() => shown.text.includes('no physics at "collection" yet'));
    document.body.append(second);
    await shown.shows('Bodies', '2');
    expect(worldOf(second)).to.not.equal(before);
    expect(monitorEffect(worldOf(second)).active).to.equal(true);
  });

  it('has costs kept only while it is in the page and in sight, and says so in world.effects', async () => {
    const { world } = await show(falling);
    expect(monitorEffect(world).active).to.equal(false);
    const shown = addMonitor('for="ball"');
    await until(() => (world.costs?.frames ?? 0) > 3);
    expect(monitorEffect(world).because!.element).to.equal(shown.monitor);
    await until(() => /last \d+ frames/.test(shown.text));
    const rows = shown.root.querySelectorAll('[part="costs"] tbody tr');
    expect([...rows].map((row) => row.firstElementChild!.textContent)).to.eql([
      'Step',
      'Read poses',
      'Write poses',
      'Listeners',
      'Together',
    ]);
    shown.monitor.style.display = 'none';
    await until(() => !monitorEffect(world).active);
    expect(world.costs).to.equal(undefined);
    shown.monitor.style.display = '';
    await until(() => monitorEffect(world).active);
    shown.monitor.remove();
    expect(monitorEffect(world).active).to.equal(false);
  });

  it('tells frames per second, steps per frame, time dropped, and whose a frame is', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    expect(world.stats.dropped).to.be.a('number');
    await until(() => /^\d/.test(shown.count('Frames per second') ?? ''));
    const { framesPerSecond, drawing } = world.costs!.pace!;
    expect(framesPerSecond).to.be.above(0);
    // x3dom draws each frame of a world that moves, and that takes time.
    expect(drawing).to.be.above(0);
    expect(shown.count('Steps per frame')).to.match(/^\d+(\.\d)?$/);
    expect(shown.count('Time dropped')).to.match(/^[\d,.]+ s$/);
    const shares = ['Physics', 'Listeners', 'Drawing', 'Rest of a frame'].map((name) =>
      Number(/^(\d+) %$/.exec(shown.count(name)!)![1]),
    );
    expect(shares.reduce((sum, share) => sum + share)).to.be.within(98, 102);
  });

  it('says of a slow page what makes it slow', async () => {
    const { x3d, world } = await show(falling);
    const shown = addMonitor();
    // Twice as long as all the rest of a frame takes here.
    let last = performance.now();
    x3d.querySelector('#collection')!.addEventListener('beforestep', () => {
      const now = performance.now();
      const end = now + Math.max(60, 2 * (now - last));
      while (performance.now() < end);
      last = performance.now();
    });
    await until(() => /most of it the page’s listeners/.test(shown.text));
    expect(Number(shown.count('Frames per second'))).to.be.below(30);
    await until(() => parseFloat(shown.count('Time dropped')!) > 0);
    expect(world.stats.dropped).to.be.above(0);
  });

  it('has a legend of the colours of debug drawing, from their own table, while that is on', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    expect(world.debugLegend).to.eql([]);
    expect(shown.part('legend')).to.equal(null);
    shown.root.querySelector<HTMLInputElement>('input')!.click();
    await until(() => !!shown.part('legend'));
    const items = [...shown.part('legend')!.children];
    expect(items.map((item) => item.textContent!.trim())).to.eql(
      world.debugLegend.map(({ means }) => means),
    );
    const { color } = world.debugLegend[0]!;
    const drawn = items[0]!.querySelector('rect')!.getAttribute('fill');
    expect(drawn).to.equal(`rgb(${color.map((part) => Math.round(part * 255)).join(' ')})`);
    shown.root.querySelector<HTMLInputElement>('input')!.click();
    await until(() => !shown.part('legend'));
  });

  it('pauses, steps once, goes on and resets', async () => {
    const { x3d, world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    shown.button(/Pause/).click();
    expect(world.paused).to.equal(true);
    expect(shown.root.querySelector('[role="status"]')!.textContent).to.equal('Paused.');
    await drawn();
    const shape = x3d.querySelector('#shape')!;
    const before = { time: world.time, y: drawnAt(shape)[1]! };
    shown.button(/Step/).click();
    expect(world.time - before.time).to.be.closeTo(world.timeStep, 1e-9);
    const ball = x3d.querySelector<X3DRigidBodyElement>('#ball')!;
    await until(() => Math.abs(drawnAt(shape)[1]! - ball.position[1]!) < 1e-5);
    expect(drawnAt(shape)[1]!).to.be.below(before.y);
    shown.button(/Reset/).click();
    expect(world.time).to.equal(0);
    shown.button(/Go on/).click();
    expect(world.paused).to.equal(false);
    await until(() => world.time > 0);
  });

  it('a single step stops what runs', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    shown.button(/Step/).click();
    expect(world.paused).to.equal(true);
  });

  it('shows and sets the level of accuracy', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    const select = shown.root.querySelector('select')!;
    expect(select.value).to.equal('standard');
    expect(select.labels![0]!.textContent).to.contain('Accuracy');
    select.value = 'fine';
    select.dispatchEvent(new Event('change'));
    expect(world.accuracy).to.equal('fine');
    world.accuracy = 'game';
    await until(() => select.value === 'game');
  });

  it('switches the debug drawing and User Timing on and off', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    const [debug, profile] = shown.root.querySelectorAll<HTMLInputElement>('input');
    expect(debug!.labels![0]!.textContent!.trim()).to.equal('Debug drawing');
    debug!.click();
    profile!.click();
    world.step(0);
    const active = (name: string): boolean =>
      world.effects.find((effect) => effect.name === name)!.active;
    expect(['debug drawing', 'user timing'].map(active)).to.eql([true, true]);
    debug!.click();
    profile!.click();
    world.step(0);
    expect(['debug drawing', 'user timing'].map(active)).to.eql([false, false]);
  });

  it('names effects with the element that switched them on, and problems with what is used', async () => {
    claim('bad-value');
    await show(falling.replace('for="shape"', 'for="shape" mass="many" torques="0 1 0"'));
    const shown = addMonitor();
    await until(() => !!shown.part('problems')?.children.length);
    expect(shown.part('effects')!.textContent).to.match(/rigid-body "ball": torques/);
    const row = (): string[] => {
      const all = [...shown.part('effects')!.querySelectorAll('tr')];
      const cells = all.find((each) => each.firstElementChild!.textContent === 'forces')!.children;
      return [...cells].map((cell) => cell.textContent!);
    };
    // Called before each step and after it, by code that every page has.
    await until(() => row()[2] === '2');
    expect(row()[1]).to.match(/^\d+\.\d\d$/);
    expect(row()[3]).to.equal('–');
    const problem = shown.part('problems')!.textContent!.replace(/\s+/g, ' ');
    expect(problem).to.contain('warning').and.to.contain('mass="many"').and.to.contain('Used: 1');
  });

  it('keeps what is focused while its numbers change', async () => {
    const { world } = await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    const button = shown.button(/Pause/);
    button.focus();
    const time = world.time;
    await until(() => world.time > time + 0.5);
    expect(shown.root.activeElement).to.equal(button);
  });

  it('has names and roles for readers, and reads out nothing that changes by itself', async () => {
    await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    expect(shown.part('base')!.getAttribute('aria-label')).to.equal('Physics monitor');
    for (const control of shown.root.querySelectorAll('button, select, input'))
      expect((control as HTMLElement).tabIndex).to.equal(0);
    expect(shown.root.querySelectorAll('[aria-live]').length).to.equal(0);
    expect(shown.root.querySelectorAll('[role="status"]').length).to.equal(1);
    expect(getComputedStyle(shown.monitor).fontVariantNumeric).to.equal('tabular-nums');
  });

  it('is light or dark as the page says, in colours that the page may set', async () => {
    await show(falling);
    const shown = addMonitor();
    await until(() => shown.count('Bodies') === '1');
    const { style } = document.documentElement;
    const color = (): string => getComputedStyle(shown.monitor).color;
    style.colorScheme = 'light';
    expect(color()).to.equal('rgb(28, 39, 51)');
    style.colorScheme = 'dark';
    expect(color()).to.equal('rgb(230, 236, 242)');
    style.colorScheme = '';
    shown.monitor.style.setProperty('--x3d-ui-text', 'rgb(1, 2, 3)');
    expect(color()).to.equal('rgb(1, 2, 3)');
  });

  it('takes a property that was set before it was defined, and none again', async () => {
    await started();
    const early = document.createElement('x3d-physics-monitor');
    Object.defineProperty(early, 'for', { value: 'b', configurable: true, writable: true });
    document.body.append(early);
    expect(early.getAttribute('for')).to.equal('b');
    await new Shown(early).shows('Bodies', '2');
    early.for = null as never;
    expect(early.hasAttribute('for')).to.equal(false);
    await new Shown(early).shows('Bodies', '1');
  });

  it('stands in a shadow root, too', async () => {
    await started();
    const host = document.body.appendChild(document.createElement('div'));
    const root = host.attachShadow({ mode: 'open' });
    root.innerHTML = '<x3d-physics-monitor for="collection"></x3d-physics-monitor>';
    await new Shown(root.firstElementChild!).shows('Bodies', '2');
  });
});
