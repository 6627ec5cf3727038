import { shakenBlock, type ShakenBlock } from '../../references/shaken-block.js';
import { below, fact } from '../core/helpers.js';

const SECONDS = 2;

/** In small steps, in each of which it goes along if friction holds it. */
function stepped({ way, rate, grip }: ShakenBlock, steps: number): number {
  const dt = SECONDS / steps;
  let [place, speed] = [0, way * rate];
  for (let i = 1; i <= steps; i++) {
    const lack = way * rate * Math.cos(rate * i * dt) - speed;
    const before = speed;
    speed += Math.sign(lack) * Math.min(Math.abs(lack), grip * dt);
    place += ((before + speed) / 2) * dt;
  }
  return place;
}

for (const [name, shaken] of Object.entries({
  'that sticks and slips': { way: 0.05, rate: 4 * Math.PI, grip: 4.9 },
  'that never sticks': { way: 0.2, rate: 4 * Math.PI, grip: 4.9 },
}))
  fact(`a shaken block ${name} goes where small steps take it`, () => {
    const exact = shakenBlock(shaken, SECONDS)(SECONDS);
    const [coarse, fine] = [1e6, 2e6].map((steps) => Math.abs(stepped(shaken, steps) - exact));
    below(coarse!, 1e-5, 'm');
    below(fine!, 0.7 * coarse!, 'm');
  });

fact('a block that is shaken less than friction holds stays on its place', () => {
  const shaken = { way: 0.01, rate: 4 * Math.PI, grip: 4.9 };
  const block = shakenBlock(shaken, SECONDS);
  for (let t = 0; t < SECONDS; t += 0.1)
    below(Math.abs(block(t) - 0.01 * Math.sin(shaken.rate * t)), 1e-15, 'm');
});
