import { expect } from 'chai';
import './console.js';
import { HASHES, towerRun } from '../core/timeline/tower.js';
import { show } from './scene.js';

const falling = `<x3d-rigid-body-collection>
    <x3d-rigid-body id="ball" for="shape"></x3d-rigid-body>
  </x3d-rigid-body-collection>
  <transform id="shape" translation="0 9 0"><shape><sphere></sphere></shape></transform>`;

describe('the timeline in a page', () => {
  it('has the hashes that it has in Node', async () => {
    expect((await towerRun()).map(({ hash }) => hash)).to.eql(HASHES);
  });

  it('records what attributes do, and runs it anew from what was exported', async () => {
    const { world } = await show(falling);
    world.paused = true;
    world.reset();
    await world.record();
    world.step(60);
    document.getElementById('ball')!.setAttribute('linearvelocity', '3 0 0');
    world.step(60);
    const run = JSON.parse(JSON.stringify(world.exportRun()));
    const hashes = world.timeline!.hashes.map(({ hash }) => hash);
    expect(run.markup).to.match(/^<scene.*id="ball"/is);
    expect(
      run.calls.some(({ args }: { args: unknown[] }) => args[0] === 'linearVelocity'),
    ).to.equal(true);
    world.reset();
    const timeline = (await world.importRun(run))!;
    expect(timeline.hashes.map(({ hash }) => hash)).to.eql(hashes);
    expect(timeline.to).to.be.closeTo(1, 1e-9);
    timeline.stop();
  });
});
