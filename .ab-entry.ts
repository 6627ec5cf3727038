export { engines, running } from './lab/price/engines.js';
export { priceScenes } from './lab/price/scenes/index.js';
