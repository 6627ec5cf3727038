import { expect } from 'chai';
import '../console.js';
import { open, type PageWindow } from '../page.js';
import { until } from '../scene.js';
import type { World } from '../inside.js';

interface Chart extends HTMLElement {
  measured: unknown[] | undefined;
  world: World | undefined;
}

/** The chart of a page whose world has started. */
async function chartOf(
  page: PageWindow,
): Promise<{ chart: Chart; root: ShadowRoot; world: World }> {
  const chart = page.document.getElementById('chart') as Chart;
  await until(() => chart.shadowRoot?.querySelector('[part=levels]') != null);
  const world = chart.world!;
  world.paused = true;
  return { chart, root: chart.shadowRoot!, world };
}

const radio = (root: ShadowRoot, level: string): HTMLInputElement =>
  [...root.querySelectorAll<HTMLInputElement>('input[type=radio]')].find(
    ({ value }) => value === level,
  )!;
const chosen = (root: ShadowRoot): string | undefined =>
  [...root.querySelectorAll<HTMLInputElement>('input[type=radio]')].find(({ checked }) => checked)
    ?.value;
const button = (root: ShadowRoot): HTMLButtonElement => root.querySelector('button')!;
const status = (root: ShadowRoot): string =>
  root.querySelector('[role=status]')!.textContent!.trim();

/** What it says in sentences, without the breaks of the source. */
const hint = (root: ShadowRoot): string =>
  [...root.querySelectorAll('p')].map((p) => p.textContent!.replace(/\s+/g, ' ')).join(' ');

async function measure(root: ShadowRoot): Promise<void> {
  button(root).click();
  await until(() => root.querySelector('svg') !== null);
}

describe('x3d-accuracy-chart', () => {
  it('draws what was measured, with every level by name, in HTML and XHTML', async () => {
    for (const path of ['chart.html', 'chart.xhtml']) {
      const { root } = await chartOf(await open(path));
      expect(status(root)).to.equal('Not measured yet.');
      expect(hint(root)).to.contain('each level has a dot');
      await measure(root);
      expect(hint(root)).not.to.contain('each level has a dot');
      const names = [...root.querySelectorAll('svg text')].map(({ textContent }) => textContent);
      const levels = ['game', 'standard', 'fine', 'precise', 'reference'];
      for (const name of [...levels, 'frame budget']) expect(names, path).to.include(name);
      const rows = [...root.querySelectorAll('tbody tr')];
      expect(rows.map((row) => row.querySelector('th')!.textContent)).to.deep.equal(levels);
      expect(root.querySelector('tr[aria-current=true] th')!.textContent).to.equal('standard');
      expect(root.querySelector('[part=chart]')!.getAttribute('aria-label')).to.contain('game');
      expect(status(root)).to.equal('Measured.');
    }
  });

  it('sets the level of the running scene, and follows where others set it', async () => {
    const { root, world } = await chartOf(await open('chart.html'));
    expect(chosen(root)).to.equal('standard');
    radio(root, 'precise').click();
    expect(world.accuracy).to.equal('precise');
    world.accuracy = 'game';
    expect(chosen(root)).to.equal('game');
    radio(root, 'auto').click();
    expect(world.get('accuracy')).to.equal('auto');
    expect(chosen(root)).to.equal('auto');
    expect(world.accuracy).to.equal('game');
  });

  it('draws the error that is asked for', async () => {
    const { root } = await chartOf(await open('chart.html'));
    await measure(root);
    const select = root.querySelector('select')!;
    const axes = (): string => root.querySelector('svg')!.textContent!;
    expect(axes()).to.contain('farthest body');
    select.value = 'joint';
    select.dispatchEvent(new Event('change'));
    expect(axes()).to.contain('widest gap');
  });

  it('names every level where it hides no other name, whichever error is drawn', async () => {
    const { root } = await chartOf(await open('chart.html'));
    await measure(root);
    const select = root.querySelector('select')!;
    for (const { value } of select.options) {
      select.value = value;
      select.dispatchEvent(new Event('change'));
      const names = [...root.querySelectorAll('svg .level')];
      expect(names.length).to.equal(5);
      const boxes = names.map((name) => name.getBoundingClientRect());
      const drawing = root.querySelector('svg')!.getBoundingClientRect();
      for (const [i, a] of boxes.entries()) {
        expect(a.left >= drawing.left && a.right <= drawing.right, `${value} ${i}`).to.be.true;
        for (const b of boxes.slice(i + 1)) {
          // Line boxes are higher than letters.
          const apart = Math.abs(a.top - b.top) >= 11;
          expect(apart || a.right <= b.left || b.right <= a.left, `${value} ${i}`).to.be.true;
        }
      }
    }
  });

  it('on a phone lists of the errors the one that is drawn, and no number is cut off', async () => {
    const { root } = await chartOf(await open('chart.html'));
    await measure(root);
    const columns = (): (string | null)[] =>
      [...root.querySelectorAll('thead th')]
        .filter((head) => head.getClientRects().length > 0)
        .map(({ textContent }) => textContent);
    expect(columns()).to.eql(['Level', 'Step', 'ms per s', 'Position']);
    const select = root.querySelector('select')!;
    select.value = 'penetration';
    select.dispatchEvent(new Event('change'));
    expect(columns()).to.eql(['Level', 'Step', 'ms per s', 'Overlap']);
    const { scrollWidth, clientWidth } = root.querySelector('.scroll')!;
    expect(scrollWidth).to.equal(clientWidth);
  });

  it('shows at once what was kept of a measurement, until another world or another measurement comes', async () => {
    const page = await open('chart.html');
    const { chart, root } = await chartOf(page);
    await measure(root);
    // An element can't be kept.
    const plain = (name: string, value: unknown) => (/worst|element/.test(name) ? null : value);
    const kept = JSON.parse(JSON.stringify(chart.measured, plain)) as Chart['measured'];
    expect(status(root)).to.equal('Measured.');
    const other = page.document.createElement('x3d-accuracy-chart') as Chart;
    other.setAttribute('for', chart.getAttribute('for')!);
    other.measured = kept;
    chart.replaceWith(other);
    await until(() => other.shadowRoot?.querySelectorAll('svg .level').length === 5);
    await until(() => status(other.shadowRoot!) === 'As it was measured earlier.');
    other.measured = undefined;
    await until(() => status(other.shadowRoot!) === 'Not measured yet.');
    other.measured = kept;
    page.document.querySelector('x3d')!.remove();
    await until(() => other.measured === undefined);
  });

  it('stops measuring when it is told to', async () => {
    const { root } = await chartOf(await open('chart.html'));
    button(root).click();
    await until(() => button(root).textContent!.trim() === 'Cancel');
    button(root).click();
    expect(button(root).textContent!.trim()).to.equal('Measure');
    expect(status(root)).to.equal('Not measured yet.');
    expect(root.querySelector('svg')).to.equal(null);
  });
});
