import { createWorld } from '../../../physics-core/create.js';
import { type StepHash } from '../../../physics-core/inside.js';

/** Of a tower that is struck, in each 60 steps: the same in Node and in every browser. */
export const HASHES = ['88a46e8c', 'bb3f742f', '488457a8', 'f63387e0', 'a4326694'];

/** What it is recorded with. */
export async function towerRun(): Promise<readonly StepHash[]> {
  const world = await createWorld({ rest: 'never' });
  world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] });
  for (let i = 0; i < 8; i++)
    world.add('RigidBody', {
      position: [i / 50, 1 + i, 0],
      geometry: [{ type: 'Box', size: [1, 1, 1] }],
    });
  const ball = world.add('RigidBody', {
    position: [-4, 6, 0.1],
    mass: 3,
    geometry: [{ type: 'Sphere', radius: 0.5 }],
  });
  world.add('BallJoint', { body1: ball, anchorPoint: [0, 10, 0] });
  const timeline = await world.record();
  world.step(100);
  ball.set('mass', 5);
  world.step(200);
  const { hashes } = timeline;
  world.destroy();
  return hashes;
}
