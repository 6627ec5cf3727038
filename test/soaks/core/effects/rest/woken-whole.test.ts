import assert from 'node:assert/strict';
import { close, fact, world, type Body } from '../../../../core/helpers.js';
import type { World } from '../../../../../physics-core/inside.js';

// What an island lies on goes: all of it falls in that step, and falls as if it had never slept.

const BOXES = 10;
const SECONDS = 0.5;
/** Metres: g t² / 2. */
const FALL = (9.8 * SECONDS ** 2) / 2;
/** Metres: what the contract lets rest cost. */
const REST = 1e-3;

interface Tower {
  made: World;
  floor: Body;
  boxes: Body[];
}

async function tower(): Promise<Tower> {
  const made = await world({ gravity: [0, -9.8, 0], rest: 'auto' });
  const floor = made.add('RigidBody', {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: [{ type: 'Box', size: [10, 1, 10] }],
  }) as Body;
  const boxes = Array.from(
    { length: BOXES },
    (_, i) =>
      made.add('RigidBody', {
        position: [0, 0.5 + i, 0],
        geometry: [{ type: 'Box', size: [1, 1, 1] }],
      }) as Body,
  );
  made.advance(6);
  assert.ok(boxes.every(({ sleeping }) => sleeping));
  return { made, floor, boxes };
}

const heightOf = (body: Body): number => (body.get('position') as number[])[1]!;

const WAYS: Record<string, (tower: Tower) => void> = {
  'is removed': ({ floor }) => floor.remove(),
  'is disabled': ({ floor }) => floor.set('enabled', false),
  'is moved away': ({ floor }) => floor.set('position', [0, -50, 0]),
  'is fixed no more': ({ floor }) => floor.set('fixed', false),
  'is another shape elsewhere': ({ floor }) =>
    floor.set('geometry', [{ type: 'Box', size: [0.1, 1, 0.1], translation: [40, 0, 0] }]),
  'is removed after the world was restored': ({ made, floor }) => {
    made.restore(JSON.parse(JSON.stringify(made.snapshot())));
    floor.remove();
  },
};

for (const [name, go] of Object.entries(WAYS))
  fact(`ten boxes asleep on a floor that ${name} fall at once, all alike`, async () => {
    const made = await tower();
    const from = made.boxes.map(heightOf);
    go(made);
    made.made.advance(SECONDS);
    made.boxes.forEach((box, i) => close(from[i]! - heightOf(box), FALL, REST));
  });

fact('whoever is woken of an island wakes all of it in that moment, each once', async () => {
  const { boxes } = await tower();
  let told = 0;
  for (const box of boxes) box.on('wake', () => told++);
  boxes[7]!.wake();
  assert.ok(boxes.every(({ sleeping }) => !sleeping));
  assert.equal(told, BOXES);
});

fact('who slept apart sleeps on, restored or not', async () => {
  const { made, boxes } = await tower();
  const apart = made.add('RigidBody', {
    position: [4, 0.5, 0],
    geometry: [{ type: 'Box', size: [1, 1, 1] }],
  }) as Body;
  made.advance(6);
  assert.ok(apart.sleeping);
  made.restore(made.snapshot());
  assert.ok(apart.sleeping && boxes[0]!.sleeping);
  boxes[0]!.wake();
  assert.ok(!boxes[9]!.sleeping);
  assert.ok(apart.sleeping);
});

fact('who is restored awake wakes nobody that the snapshot has asleep', async () => {
  const { made, boxes } = await tower();
  boxes[9]!.remove();
  made.advance(6);
  const before = made.snapshot();
  boxes[0]!.wake();
  assert.ok(boxes.slice(0, 9).every(({ sleeping }) => !sleeping));
  made.restore(before);
  assert.ok(boxes.slice(0, 9).every(({ sleeping }) => sleeping));
});

for (const accuracy of ['game', 'standard', 'precise'])
  fact(
    `two links that hang asleep fall together once they are let go, at ${accuracy}`,
    async () => {
      const made = await world({ gravity: [0, -9.8, 0], rest: 'auto', accuracy });
      let before = made.add('RigidBody', { fixed: true });
      const joints = [1, 2].map((i) => {
        const link = made.add('RigidBody', {
          position: [0, -i / 2, 0],
          geometry: [{ type: 'Sphere', radius: 0.1 }],
        });
        const ends = { body1: link, body2: before };
        before = link;
        return made.add('BallJoint', { ...ends, anchorPoint: [0, 0.25 - i / 2, 0] });
      });
      const links = joints.map((joint) => joint.get('body1') as Body);
      made.advance(6);
      assert.ok(links.every(({ sleeping }) => sleeping));
      const from = links.map(heightOf);
      joints[0]!.remove();
      made.advance(SECONDS);
      links.forEach((link, i) => close(from[i]! - heightOf(link), FALL, 1e-4));
    },
  );
