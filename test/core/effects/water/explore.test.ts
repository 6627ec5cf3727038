import { box, sphere, fact, world } from '../../helpers.js';
import { addSea } from './helpers.js';
const mean = (p: number[][]) => p.reduce((s, x) => s + x[1]!, 0) / p.length;
fact('explore', async () => {
  for (const accuracy of ['game', 'standard', 'fine']) {
    const w = await world({ accuracy } as never);
    addSea(w, { damping: 6 });
    const jelly = w.add('SoftBody', { mass: 62.5, youngsModulus: 2e4, poissonsRatio: 0.45, geometry: box(0.5) });
    const t = Date.now();
    w.advance(6);
    const p = jelly.get('positions') as number[][];
    console.log(accuracy, 'half cube: mean height', mean(p), 'low', Math.min(...p.map((q) => q[1]!)), (Date.now() - t), 'ms');
    console.log(JSON.stringify(await w.ask('explain', w.nodes.find?.((n: any) => n.type.name === 'WaterVolume') ?? jelly)).slice(0, 300));
  }
  {
    const w = await world();
    addSea(w, {damping: 0});
    const stone = w.add('SoftBody', { mass: 250, youngsModulus: 1e7, poissonsRatio: 0.3, geometry: { ...box(0.5), translation: [0, -2, 0] } });
    let last = mean(stone.get('positions') as number[][]);
    for (let i = 0; i < 8; i++) {
      w.advance(0.5);
      const now = mean(stone.get('positions') as number[][]);
      console.log('v', (now - last) / 0.5, 'terminal', Math.sqrt((250 - 125) * 9.8 / (0.5 * 1000 * 0.25)));
      last = now;
    }
  }
});
