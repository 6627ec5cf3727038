import { show } from '../../scene.js';

export async function held(markup: string) {
  const { x3d, world } = await show(markup);
  world.paused = true;
  const find = (selector: string): Element => x3d.querySelector(selector)!;
  const at = (name = 'ball') => world.node(name)!.get('position') as number[];
  return { x3d, world, find, at };
}
