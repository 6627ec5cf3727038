import { expect } from 'chai';
import { place, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';
import { ball, collection, outcome } from './collections.js';

describe('ready', () => {
  it('rejects with a problem where the <x3d> goes before the start', async () => {
    for (const markup of [ball('id="b"'), collection('id="b"')]) {
      const x3d = place(markup);
      const world = worldOf(x3d.querySelector('#b'))!;
      x3d.remove();
      expect(await outcome(world)).to.equal('world-ended');
      const problem = await world.ready.catch((reason: unknown) => reason);
      expect(problem).to.deep.include({ severity: 'info', element: x3d });
    }
  });

  it('rejects with a problem where the collection goes before the start, and not where it stays', async () => {
    const x3d = place(collection('id="goes"') + collection('id="stays"'));
    const [goes, stays] = ['#goes', '#stays'].map((id) => worldOf(x3d.querySelector(id))!);
    x3d.querySelector('#goes')!.remove();
    expect(await outcome(goes!)).to.equal('world-ended');
    expect(await outcome(stays!)).to.equal('ready');
  });
});

describe('a page without physics', () => {
  it('makes no world where its start took too long', async () => {
    const requests = (globalThis as unknown as { x3dom: { RequestManager: object } }).x3dom
      .RequestManager as { addRequest(request: unknown): void };
    const { addRequest } = requests;
    requests.addRequest = () => {};
    const now = performance.now.bind(performance);
    try {
      const x3d = place('<inline url="/never.x3d"></inline>');
      await wait(200);
      performance.now = () => now() + 10_000;
      await wait(200);
      expect(worldOf(x3d)).to.equal(undefined);
    } finally {
      delete (performance as { now?: unknown }).now;
      requests.addRequest = addRequest;
    }
  });
});
