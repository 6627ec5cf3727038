// The core where there is no page: in Node, without the types of the DOM.
import { createWorld, type Body } from 'x3d-physics/core';

export async function fall(): Promise<number> {
  const world = await createWorld({ gravity: [0, -9.8, 0] });
  const ball: Body = world.add('RigidBody', { geometry: [{ type: 'Sphere', radius: 0.5 }] });
  world.advance(1);
  ball.applyImpulse([0, 1, 0]);
  // @ts-expect-error There is no such type.
  world.add('RigidBdy');
  return ball.get('position')[1];
}
