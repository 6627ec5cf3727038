import { expect } from 'chai';
import '../console.js';
import { until, wait } from '../scene.js';
import { open, openText, type PageWindow } from '../page.js';
import { Shown } from './monitor.js';
import type { World } from '../inside.js';

const SCENE = `<x3d width="200px" height="100px"><scene>
    <transform><shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>
  </scene></x3d>`;

const page = (script: string, body: string): Promise<PageWindow> =>
  openText(`<!DOCTYPE html>
    <script src="/node_modules/x3dom/x3dom.js"></script>
    ${script}${SCENE}${body}`);

const monitorIn = ({ document }: Window): Shown =>
  new Shown(document.querySelector('x3d-physics-monitor')!);

const loaded = (window: Window): string[] =>
  window.performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname);

const MODULE = '<script type="module" src="/dist/x3d-physics.js"></script>';
const MONITOR = '<x3d-physics-monitor></x3d-physics-monitor>';

describe('the monitor in the builds', () => {
  it('comes with the first of its elements; a page without one loads no ui', async () => {
    const window = await page(MODULE, '');
    await wait(500);
    expect(loaded(window).filter((path) => path.includes('/ui/'))).to.eql([]);
    window.document.body.insertAdjacentHTML('beforeend', MONITOR);
    await monitorIn(window).shows('Bodies', '1');
    expect(loaded(window)).to.include('/dist/ui/monitor.js');
  });

  it('nor does a page without debug load what draws', async () => {
    const window = await page(MODULE, '');
    const { worldOf } = (await (window as unknown as { eval(text: string): unknown }).eval(
      "import('/dist/x3d-physics.js')",
    )) as { worldOf(element: Element): World };
    const world = worldOf(window.document.getElementById('b')!);
    await world.ready;
    const drawing = (): string[] => loaded(window).filter((path) => /sketch|debug/.test(path));
    await until(() => world.time > 0.2);
    expect(drawing()).to.eql([]);
    world.set('debug', true);
    await until(() => drawing().length === 2);
  });

  it('its module exports the class and defines nothing', async () => {
    const window = await page('', '');
    const module = (await (window as unknown as { eval(text: string): unknown }).eval(
      "import('/dist/elements/x3d-physics-monitor.js')",
    )) as { X3DPhysicsMonitorElement: CustomElementConstructor };
    expect(window.customElements.get('x3d-physics-monitor')).to.equal(undefined);
    window.customElements.define('my-monitor', module.X3DPhysicsMonitorElement);
    window.document.body.append(window.document.createElement('my-monitor'));
    const shown = new Shown(window.document.querySelector('my-monitor')!);
    await until(() => shown.text.includes('Physics'));
  });

  for (const path of ['monitor.html', 'monitor.xhtml']) {
    it(`${path}: the classic script loads the ui from beside itself`, async () => {
      const shown = monitorIn(await open(path));
      await shown.shows('Bodies', '1');
      expect(shown.part('problems')!.textContent).to.contain('mass="many"');
      shown.button(/Pause/).click();
      await until(() => shown.text.includes('Paused.'));
      expect(shown.button(/Go on/).disabled).to.equal(false);
    });
  }

  it('a ui that is not there is a problem that says where it was looked for', async () => {
    const source = await (await fetch('/dist/x3d-physics.classic.js')).text();
    const window = await page('', '');
    const heard: { code: string; severity: string }[] = [];
    window.addEventListener('physicsproblem', (event) =>
      heard.push((event as CustomEvent<{ code: string; severity: string }>).detail),
    );
    const script = window.document.createElement('script');
    script.src = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    window.document.head.append(script);
    window.document.body.insertAdjacentHTML('beforeend', MONITOR);
    const shown = monitorIn(window);
    await until(() => shown.text.includes('could not be loaded'));
    const problem = heard.find(({ code }) => code === 'ui-load-failed')!;
    expect(problem.severity).to.equal('error');
    expect(shown.monitor.matches(':state(problem)')).to.equal(true);
  });
});
