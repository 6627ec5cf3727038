// What is asked of each library in its page of bodies.
import type { Adapter } from './adapter.js';
import * as ammo from './ammo.js';
import { watchMethod } from './frames.js';

const page = window as any;

let ticks = false;
/** X3DOM's own frame is watched. */
function watchTicks(): boolean {
  const canvas = page.x3dom.canvases[0];
  if (canvas && !ticks) watchMethod(canvas, 'tick', 'tick');
  return (ticks ||= Boolean(canvas));
}

const ours: Adapter = {
  ready: () => Boolean(ourWorld()?.started) && watchTicks(),
  physics() {
    const { step, read, write, events } = ourWorld().stats.ms;
    return step + read + write + events;
  },
  height: () => ourWorld()?.node('b0')?.get('position')[1],
};

const oursInWorker: Adapter = {
  ...ours,
  ready: () => ours.ready() && ourWorld().mirrored > 0,
  // What it tells is of the worker.
  physics: ({ script, tick }) => script - tick,
  answered: () => !ourWorld().elsewhere.waits,
};

export const ourWorld = () => document.querySelector<any>('x3d-rigid-body')?.world;

let watched = false;
const xIteNode = (name: string) => {
  try {
    return document.querySelector<any>('x3d-canvas').browser.currentScene.getNamedNode(name);
  } catch {
    return undefined; // Not there yet.
  }
};

const xIte: Adapter = {
  ready() {
    const world = xIteNode('world')?.getValue();
    if (!world || watched) return watched;
    watchMethod(world, 'update');
    // It was bound when its collection began.
    world.getBrowser().sensorEvents().removeInterest('update', world);
    world.set_enabled__();
    return (watched = true);
  },
  height: () => xIteNode('b0')?.position.y,
};

let bodies: number | undefined;
const aFrame: Adapter = {
  ready() {
    const scene = document.querySelector<any>('a-scene');
    const physics = scene?.systems?.physics;
    if (!physics?.initialized) return false;
    const all = [...document.querySelectorAll<any>('[ammo-body]')];
    if (bodies === undefined) {
      for (const name of ['tick', 'tock']) if (physics[name]) watchMethod(physics, name);
      bodies = all.length;
    }
    return all.every(({ body }) => body);
  },
  height: () => document.querySelector<any>('#b0')?.object3D?.position.y,
};

export const adapters: Record<string, Adapter> = {
  ours,
  'ours-worker': oursInWorker,
  'x-ite': xIte,
  'a-frame': aFrame,
  ammo,
};

if (page.scene) void ammo.begin(page.scene);
