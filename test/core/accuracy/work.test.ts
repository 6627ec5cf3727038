import { workPerMoment } from '../../../physics-core/accuracy/work.js';
import { above, close, fact } from '../helpers.js';

fact('work is the mean of what is usual, whatever else the machine does, by any clock', () => {
  const steady = Array.from({ length: 100 }, (_, i) => 2 + (i % 2));
  close(workPerMoment(steady), 2.5, 1e-9, 'ms');
  const disturbed = steady.map((ms, i) => (i % 10 === 0 ? 80 : ms));
  // Ten of the moments that take 2 ms count as the usual 3.
  close(workPerMoment(disturbed), 2.6, 1e-9, 'ms');
  // A clock that ticks once a millisecond shows 0.2 ms as 0 or 1.
  const ticks = Array.from({ length: 100 }, (_, i) => (i % 5 === 0 ? 1 : 0));
  close(workPerMoment(ticks), 0.2, 0.01, 'ms');
  above(workPerMoment([0, 0, 0]), 0, 'ms');
});
