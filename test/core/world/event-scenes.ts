import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/inside.js';
import { addBody, addFloor, box, world, type Node } from '../helpers.js';

/** What collision events tell. */
export interface Touch {
  other: Node;
  contacts: unknown[];
  time: number;
  reason?: string;
}

/** A ball that touches the floor within a step or two, and another one beside it that does so in the same step. */
export async function landing() {
  const w = await world();
  const floor = addFloor(w);
  const [ball, beside] = [0, 5].map((x) => addBody(w, { position: [x, 0.55, 0] }));
  return { w, floor, ball: ball!, beside: beside! };
}

/** What a node tells of its collisions, in words. */
export function hear(node: Node, log: string[], name: string): void {
  for (const event of ['collisionstart', 'collisionend'])
    node.on(event, (detail) => {
      const { reason } = detail as Touch;
      log.push(`${name} ${event}${reason ? ` ${reason}` : ''}`);
    });
}

/** Poses of all bodies after each step. */
export function record(w: World): number[][] {
  const log: number[][] = [];
  w.on('afterstep', () => log.push([...w.bodies].flatMap((body) => body.readPose([]) as number[])));
  return log;
}

export const asleepAt = (y: number) => ({
  position: [0, y, 0],
  geometry: [box(1)],
  autoDisable: true,
  disableTime: 0.1,
  disableLinearSpeed: 1,
  disableAngularSpeed: 1,
});

/** Two boxes on each other, asleep. */
export async function sleepers() {
  const w = await world();
  const floor = addFloor(w);
  const [low, high] = [addBody(w, asleepAt(0.5)), addBody(w, asleepAt(1.5))];
  w.advance(1);
  assert.ok(low.sleeping && high.sleeping);
  return { w, floor, low, high };
}
