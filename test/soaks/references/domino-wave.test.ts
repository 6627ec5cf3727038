import { dominoSpeed, type DominoRow } from '../../../references/domino-wave.js';
import { below, fact } from '../../core/helpers.js';

const row: DominoRow = { height: 0.24, thickness: 0.03, gap: 0.07, friction: 0.5, gravity: 9.8 };

fact('half the step changes nothing of the speed of a wave of dominoes', () => {
  below(Math.abs(dominoSpeed(row, 50) / dominoSpeed(row, 100) - 1), 1e-5, 'of the speed');
});

fact('dominoes of four times the size fall twice as fast', () => {
  const large = { ...row, height: 0.96, thickness: 0.12, gap: 0.28 };
  below(Math.abs(dominoSpeed(large, 50) / dominoSpeed(row, 50) - 2), 1e-9, 'off twice');
});

fact('friction of one on the next slows a wave of dominoes', () => {
  const speeds = [0, 0.2, 0.5].map((friction) => dominoSpeed({ ...row, friction }, 50));
  // 2.84, 2.21 and 1.65 m/s.
  below(speeds[1]!, speeds[0]!, 'm/s');
  below(speeds[2]!, speeds[1]!, 'm/s');
});
