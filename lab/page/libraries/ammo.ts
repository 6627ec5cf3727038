import { HOOKS, type Library } from './library.js';

export const ammo: Library = {
  id: 'ammo',
  name: 'Ammo alone',
  says: 'our build of Ammo and nothing else: two steps of 1/120 s, nothing read, nothing drawn',
  type: 'text/html; charset=utf-8',
  page: (scene) =>
    `<!DOCTYPE html><meta charset="utf-8"><script>scene = ${JSON.stringify(scene)}</script><script src="/node_modules/ammojs-typed/ammo/ammo.wasm.js"></script>${HOOKS('ammo')}`,
};
