import { fact, world, addBody, addJoint, addFloor, box, position, WEIGHTLESS } from './core/helpers.js';
fact('G', async () => {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  const ball = addBody(w);
  const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 1], maxAngle: 0.5, stopErrorCorrection: 0.3 });
  w.step();
  hinge.set('stopErrorCorrection', 0.2);
  ball.set('orientation', [0, 0, 1, 0.6]);
  w.step();
  console.log('G', hinge.angle - 0.5, ball.get('orientation'));
  w.step();
  console.log('G', hinge.angle - 0.5, ball.get('orientation'), w.time, w.stepsTaken);
});
fact('D', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  for (let i = 0; i < 200; i++) w.frame(1 / 60);
  let n = 0; while (w.frame(1 / 60)) n++;
  let calls = 0;
  w.onwork = () => calls++;
  console.log('D', n, stone.sleeping, (w as any).edits.pending);
  stone.set('linearVelocity', [0, 3, 0]);
  console.log('D', calls, w.stepping.needsFrame, (w as any).edits.pending);
});
