import type { PriceScene } from '../scene.js';
import { grounds } from './grounds.js';
import { heaps } from './heaps.js';
import { jointed } from './jointed.js';

export const priceScenes: readonly PriceScene[] = [...heaps, ...jointed, ...grounds];
