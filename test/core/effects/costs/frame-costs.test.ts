import assert from 'node:assert/strict';
import { PerformanceObserver } from 'node:perf_hooks';
import { describe } from 'node:test';
import { FrameCosts } from '../../../../physics-core/effects/costs/frame-costs.js';
import { addBody, fact, world } from '../../helpers.js';

const effect = (w: Awaited<ReturnType<typeof world>>, name: string) =>
  w.effects.find((each) => each.name === name)!;

describe('the costs of frames', () => {
  fact('are told by nearest rank over the last 240 frames', () => {
    const costs = new FrameCosts();
    costs.record('somebody', 'a reason');
    for (let k = 1; k <= 300; k++) {
      costs.afterStep();
      costs.frameOver({ step: k, read: 0, write: 1, events: 0 });
    }
    // Of 61 to 300 ms.
    assert.deepEqual(costs.report, {
      frames: 240,
      step: { p50: 180, p90: 276, p99: 298 },
      read: { p50: 0, p90: 0, p99: 0 },
      write: { p50: 1, p90: 1, p99: 1 },
      events: { p50: 0, p90: 0, p99: 0 },
      total: { p50: 181, p90: 277, p99: 299 },
      pace: undefined,
    });
  });

  fact('are kept only while somebody looks, who stands in world.effects', async () => {
    const w = await world();
    addBody(w);
    w.frame(1 / 60);
    w.stepping.frameOver(0);
    assert.equal(w.costs, undefined);
    assert.equal(effect(w, 'monitor').active, false);
    const stop = w.recordCosts('me', 'to know');
    assert.deepEqual(effect(w, 'monitor').because, { element: 'me', reason: 'to know' });
    w.frame(1 / 60);
    w.stepping.frameOver(0);
    assert.equal(w.costs!.frames, 1);
    stop();
    assert.equal(w.costs, undefined);
    assert.equal(effect(w, 'monitor').active, false);
  });

  fact('count each millisecond in one phase', async () => {
    // Without gravity: free flight would look at the clock, too.
    const w = await world({ gravity: [0, 0, 0] });
    addBody(w);
    w.step(0);
    const { now } = performance;
    let ticks = 0;
    performance.now = () => ticks++;
    w.frame(1 / 120);
    w.stepping.frameOver(performance.now());
    performance.now = now;
    // One tick lies between the readings of the clock around reading poses, and around writing them.
    assert.deepEqual(w.stats.ms, { step: 2, read: 1, write: 1, events: 0 });
  });

  fact('leave out frames in which no step was taken', async () => {
    const w = await world();
    addBody(w);
    w.recordCosts('me');
    for (const seconds of [1 / 60, 0, 0, 1 / 60]) {
      w.frame(seconds);
      w.stepping.frameOver(0);
    }
    assert.equal(w.costs!.frames, 2);
  });
});

describe('User Timing', () => {
  fact('has a measure for each phase while profile is true, and keeps none', async () => {
    const w = await world();
    addBody(w);
    w.on('afterstep', () => {});
    const observer = new PerformanceObserver(() => {});
    observer.observe({ entryTypes: ['measure'] });
    const frame = (): string[] => {
      w.frame(1 / 120);
      w.stepping.frameOver(0);
      return [...new Set(observer.takeRecords().map(({ name }) => name))].sort();
    };
    assert.equal(w.profile, false);
    assert.deepEqual(frame(), []);
    w.profile = true;
    assert.deepEqual(
      frame(),
      ['events', 'read', 'step', 'write'].map((phase) => `x3d-physics ${phase}`),
    );
    assert.equal(effect(w, 'user timing').active, true);
    assert.equal(performance.getEntriesByType('measure').length, 0);
    w.profile = false;
    assert.deepEqual(frame(), []);
    observer.disconnect();
  });
});

describe('the pace of frames', () => {
  fact('tells frames per second, steps per frame, and who has which share of a frame', () => {
    const costs = new FrameCosts();
    costs.record('somebody', 'a reason');
    for (let k = 0; k < 10; k++) {
      for (let step = 0; step < 3; step++) costs.afterStep();
      costs.frameOver({ step: 30, read: 2, write: 3, events: 16 }, 0.16, 77);
    }
    const near = (value: number, wanted: number): void =>
      assert.ok(Math.abs(value - wanted) < 1e-9, `${value} is ${wanted}`);
    const pace = costs.report!.pace!;
    near(pace.framesPerSecond, 6.25);
    near(pace.stepsPerFrame, 3);
    near(pace.ms, 160);
    near(pace.physics, 0.2);
    near(pace.listeners, 0.1);
    near(pace.drawing, 0.5);
  });

  fact('counts frames without a step, and none that follows no other', () => {
    const costs = new FrameCosts();
    costs.record('somebody', 'a reason');
    const ms = { step: 1, read: 0, write: 0, events: 0 };
    costs.afterStep();
    costs.frameOver(ms, 0);
    assert.equal(costs.report!.pace, undefined);
    for (let k = 0; k < 40; k++) {
      if (k % 4 === 0) costs.afterStep();
      costs.frameOver(ms, 1 / 240);
    }
    const { framesPerSecond, stepsPerFrame } = costs.report!.pace!;
    assert.equal(Math.round(framesPerSecond), 240);
    assert.equal(stepsPerFrame, 0.25);
  });

  fact('looks back on two seconds', () => {
    const costs = new FrameCosts();
    costs.record('somebody', 'a reason');
    const ms = { step: 1, read: 0, write: 0, events: 0 };
    costs.afterStep();
    for (let k = 0; k < 600; k++) costs.frameOver(ms, 1 / 10);
    assert.equal(Math.round(costs.report!.pace!.framesPerSecond), 10);
    for (let k = 0; k < 130; k++) costs.frameOver(ms, 1 / 64);
    assert.equal(costs.report!.pace!.framesPerSecond, 64);
  });

  fact('asks what the picture took only while somebody looks', async () => {
    const w = await world();
    addBody(w);
    let asked = 0;
    const frame = (): void => {
      w.frame(1 / 50);
      w.stepping.frameOver(performance.now(), () => {
        asked++;
        return 10;
      });
    };
    frame();
    assert.equal(asked, 0);
    const stop = w.recordCosts('me');
    frame();
    assert.equal(asked, 1);
    const { framesPerSecond, drawing } = w.costs!.pace!;
    assert.equal(Math.round(framesPerSecond), 50);
    assert.ok(drawing >= 0.5 && drawing < 0.9, `half of 20 ms at least: ${drawing}`);
    stop();
    frame();
    assert.equal(asked, 1);
  });
});

describe('the time that was dropped', () => {
  fact('is counted in seconds of the clock from the start on, slow motion or not', async () => {
    const w = await world();
    addBody(w);
    const lost = (wanted: number): void =>
      assert.ok(Math.abs(w.stats.dropped - wanted) < 1e-9, `${w.stats.dropped} is ${wanted}`);
    w.frame(1 / 60);
    lost(0);
    // A frame makes up for a tenth of a second at most.
    w.frame(0.25);
    lost(0.15);
    w.timeScale = 0.5;
    w.frame(0.3);
    lost(0.25);
  });
});
