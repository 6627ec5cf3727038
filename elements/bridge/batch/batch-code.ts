import { Drawer, type DrawnScene } from './drawer.js';

// What pages fetch to draw many bodies in one call. The build writes beside it how many `bytes` that is.

export const provide = (scene: DrawnScene, bytes: number): Drawer => new Drawer(scene, bytes);
