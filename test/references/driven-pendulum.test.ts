import { drivenPendulum, type DrivenPendulum } from '../../references/driven-pendulum.js';
import { below, fact } from '../core/helpers.js';

const SECONDS = 5;
const FRAMES = 60 * SECONDS;

fact('half the step changes no angle of a driven pendulum', () => {
  const pendulum: DrivenPendulum = { arm: 1, moment: 1.004, way: 0.1, gravity: 9.81 };
  const [coarse, fine] = [drivenPendulum(pendulum, 64), drivenPendulum(pendulum, 128)];
  let off = 0;
  for (let frame = 0; frame <= FRAMES; frame++)
    off = Math.max(off, Math.abs(coarse(frame) - fine(frame)));
  below(off, 1e-11, 'rad');
});

fact('driven a little, it swings as a driven oscillator does', () => {
  const way = 1e-5;
  const pendulum: DrivenPendulum = { arm: 1, moment: 1, way, gravity: 9.81 };
  const angle = drivenPendulum(pendulum, 64);
  const [own, by] = [Math.sqrt(9.81), 2 * Math.PI];
  let off = 0;
  for (let frame = 0; frame <= FRAMES; frame++) {
    const t = frame / 60;
    const exact =
      ((-way * by ** 2) / (own ** 2 - by ** 2)) * (Math.cos(by * t) - Math.cos(own * t));
    off = Math.max(off, Math.abs(angle(frame) - exact));
  }
  below(off / way, 1e-8, 'of the way');
});
