// What is asked of each library in its page of particles; their steps are what `physics` says.
import type { Adapter } from '../../page/in-page/adapter.js';
import { watchMethod } from '../../page/in-page/frames.js';

const page = window as any;

const mean = (values: readonly number[]): number | undefined =>
  values.length > 0 ? values.reduce((sum, value) => sum + value, 0) / values.length : undefined;

const system = () => document.querySelector<any>('x3d-particle-system');

const ours: Adapter = {
  ready: () => Boolean(system()?.world?.started),
  physics() {
    const { step, read, events } = system().world.stats.ms;
    return step + read + events;
  },
  height: () => mean((system().positions as number[][]).map(([, y]) => y!)),
  count: () => system().count,
};

let watched = false;

function xIteSystem(): any {
  try {
    const { browser } = document.querySelector<any>('x3d-canvas');
    return browser.currentScene.getNamedNode('system').getValue();
  } catch {
    return undefined; // Not there yet.
  }
}

/** They move on the graphics card: nobody can tell where they are. */
const xIte: Adapter = {
  ready() {
    const node = watched ? undefined : xIteSystem();
    if (!node) return watched;
    watchMethod(node, 'animateParticles');
    // It was bound when the system began.
    const frames = node.getBrowser().sensorEvents();
    frames.removeInterest('animateParticles', node);
    frames.addInterest('animateParticles', node);
    return (watched = true);
  },
  height: () => undefined,
  count: () => xIteSystem().numParticles,
};

/** What it moves particles by, and bears them by; what they are drawn with it makes in the method around that. */
const STEP = '_update';

const babylon: Adapter = {
  ready() {
    const there = page.fountain?.isReady();
    if (there && !watched) watchMethod(page.fountain, STEP);
    return (watched = Boolean(there));
  },
  height: () => mean(page.fountain.particles.map((one: any) => one.position.y)),
  count: () => page.fountain.particles.length,
};

export const adapters: Record<string, Adapter> = { ours, 'x-ite': xIte, babylon };
