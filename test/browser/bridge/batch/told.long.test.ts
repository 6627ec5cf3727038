import { expect } from 'chai';
import '../../console.js';
import { drawn, show, until } from '../../scene.js';
import { explain } from '../../../../elements/index.js';
import { bodies, colored, draws, showBatched } from './pictures.js';

const boxes = bodies(12, (i) => `${colored(i)}<box size="1 1 1"></box>`);
const ONE = `<transform translation="0 3.4 0"><shape>${colored(1)}<cone></cone></shape><x3d-rigid-body id="one"></x3d-rigid-body></transform>`;

describe('a page where bodies are drawn in one call', () => {
  it('says how many draws that saves, and because of which bodies', async () => {
    const { x3d, world } = await showBatched(boxes + ONE);
    expect(world.stats).to.include({ batches: 1, drawsSaved: 11 });
    const report = world.effects.find(({ name }) => name === 'batched drawing')!;
    expect(report.active).to.equal(true);
    expect(report.because!.element).to.equal(x3d.querySelector('#b0'));
    expect(report.elements.length).to.equal(12);
    x3d.querySelector('#b3')!.setAttribute('batch', 'false');
    await drawn();
    draws(x3d);
    expect(world.stats).to.include({ batches: 1, drawsSaved: 10 });
  });

  it('takes a body out of them by its property, too', async () => {
    const { x3d, world } = await showBatched(boxes);
    const body = x3d.querySelector('#b3') as Element & { batch: boolean };
    expect(body.batch).to.equal(true);
    body.batch = false;
    await drawn();
    draws(x3d);
    expect([body.batch, world.stats.drawsSaved]).to.eql([false, 10]);
    body.batch = true;
    await drawn();
    draws(x3d);
    expect([body.getAttribute('batch'), world.stats.drawsSaved]).to.eql([null, 11]);
  });

  it('explains of each body how it is drawn', async () => {
    const { x3d } = await showBatched(boxes + ONE);
    const said = (name: string) => explain(x3d.querySelector(name)!).drawing;
    expect(said('#b3')).to.equal('in one call with 11 others that look alike');
    expect(said('#s3')).to.equal('in one call with 11 others that look alike');
    expect(said('#one')).to.equal('by itself: fewer than 8 look alike and stand in one group');
    x3d.querySelector('#s3 material')!.setAttribute('transparency', '0.5');
    await drawn();
    draws(x3d);
    expect(said('#b3')).to.equal('by itself: it is transparent');
  });

  it('says nothing of it where only few bodies are', async () => {
    const { x3d, world } = await show(
      bodies(5, (i) => `${colored(i)}<box></box>`),
      '#b0',
    );
    await until(() => draws(x3d) === 5);
    expect(world.stats).to.not.have.property('batches');
    expect(world.effects.some(({ name }) => name === 'batched drawing')).to.equal(false);
    expect(explain(x3d.querySelector('#b0')!)).to.not.have.property('drawing');
  });
});
