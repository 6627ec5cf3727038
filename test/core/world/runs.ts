import { World } from '../../../physics-core/inside.js';
import { addBody, addFloor, addJoint, box, claim, random } from '../helpers.js';

/** Poses of all bodies after every step, as bits. */
export function recorded(w: World): number[][] {
  const log: number[][] = [];
  w.on('afterstep', () => log.push([...w.bodies].flatMap((body) => body.readPose([]) as number[])));
  return log;
}

/** Boxes that fall on each other, a pendulum and a motor. */
export function busy(w: World): void {
  // Its bodies begin a little inside each other, so that they push.
  claim(w, 'initial-overlap');
  addFloor(w);
  const next = random(7);
  for (let i = 0; i < 8; i++)
    addBody(w, {
      position: [next() - 0.5, 1 + i, next() - 0.5],
      orientation: [0, 0, 1, next()],
      geometry: [box(0.8)],
    });
  const bob = addBody(w, { position: [4, 6, 0], mass: 3 });
  addJoint(w, 'SingleAxisHingeJoint', {
    body1: bob,
    anchorPoint: [3, 6, 0],
    axis: [0, 0, 1],
    minAngle: -1,
    stopBounce: 0.5,
  });
  w.add('MotorJoint', { body1: bob, axis1Torque: 0.5 });
}
