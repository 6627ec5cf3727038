import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  close,
  counts,
  height,
  sphere,
  spin,
  way,
  world,
  type Node,
} from '../../../helpers.js';
import type { Row } from '../row.js';

/** A body at rest on the floor, made of one collidable, under an offset if so wished. */
async function standing(
  fields: Record<string, unknown>,
  offset?: Record<string, unknown>,
  type = 'CollidableShape',
) {
  const w = await world();
  addFloor(w);
  const collidable = w.add(type, fields);
  const placed = offset ? w.add('CollidableOffset', { ...offset, collidable }) : collidable;
  const body = addBody(w, { position: [0, 3, 0], geometry: [placed] });
  w.advance(2);
  return { w, body, collidable, offset: placed };
}

type Standing = Awaited<ReturnType<typeof standing>>;

/** Lifts the body, edits, and says how high it comes to rest; the same Bullet body, nothing made or unmade. */
function restsAt({ w, body }: Standing, edit: () => void): number {
  const before = counts(w);
  const { pointer } = body;
  edit();
  body.event('position', [0, 3, 0]);
  body.event('orientation', [0, 0, 1, 0]);
  body.event('angularVelocity', [0, 0, 0]);
  w.advance(2);
  assert.equal(body.pointer, pointer);
  assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
  return height(body);
}

const enabled = (of: (scene: Standing) => Node): Row => ({
  field: 'enabled',
  fact: 'a collidable taken out lets the body fall through the floor, and holds it again when put back',
  run: async () => {
    const scene = await standing({ shape: [box(1)] }, {});
    const { w, body } = scene;
    close(height(body), 0.5, 1e-3, 'm');
    of(scene).set('enabled', false);
    w.advance(0.5);
    close(height(body), 0.5 - way(9.8, 0.5), 2e-3, 'm, taken out');
    of(scene).unset('enabled');
    body.event('linearVelocity', [0, 0, 0]);
    close(
      restsAt(scene, () => {}),
      0.5,
      1e-3,
      'm, put back',
    );
  },
});

export const shapeRows: Row[] = [
  enabled(({ collidable }) => collidable),
  {
    field: 'translation',
    fact: 'inside an offset it moves the shape; directly in a body it moves nothing',
    run: async () => {
      const inOffset = await standing({ shape: [box(1)] }, {});
      const lifted = restsAt(inOffset, () => inOffset.collidable.set('translation', [0, -1, 0]));
      close(lifted, 1.5, 1e-3, 'm, shape a metre below the origin');
      const unset = restsAt(inOffset, () => inOffset.collidable.unset('translation'));
      close(unset, 0.5, 1e-3, 'm, unset');
      const direct = await standing({ shape: [box(1)] });
      const same = restsAt(direct, () => direct.collidable.set('translation', [0, -1, 0]));
      close(same, 0.5, 1e-3, 'm, directly in the body');
    },
  },
  {
    field: 'rotation',
    fact: 'inside an offset it turns the shape; directly in a body it turns nothing',
    run: async () => {
      const quarter = [0, 0, 1, Math.PI / 2];
      const inOffset = await standing({ shape: [box(3, 1, 3)] }, {});
      close(height(inOffset.body), 0.5, 1e-3, 'm, lying');
      const upright = restsAt(inOffset, () => inOffset.collidable.set('rotation', quarter));
      close(upright, 1.5, 2e-3, 'm, standing');
      const direct = await standing({ shape: [box(3, 1, 3)] });
      const same = restsAt(direct, () => direct.collidable.set('rotation', quarter));
      close(same, 0.5, 1e-3, 'm, directly in the body');
    },
  },
  {
    field: 'shape',
    fact: 'another shape gives another rest height and moment',
    run: async () => {
      const scene = await standing({ shape: [box(1)] });
      const tall = restsAt(scene, () => scene.collidable.set('shape', [box(2)]));
      close(tall, 1, 1e-3, 'm, box of 2 m');
      const round = restsAt(scene, () => scene.collidable.set('shape', [sphere(0.7)]));
      close(round, 0.7, 1e-3, 'm, sphere');
      const { w, body } = scene;
      body.set('useGlobalGravity', false);
      body.event('position', [0, 5, 0]);
      body.event('linearVelocity', [0, 0, 0]);
      body.event('angularVelocity', [0, 0, 0]);
      body.set('torques', [[0, 1, 0]]);
      w.advance(0.1);
      close(spin(body)[1], 0.1 / (0.4 * 0.49), 1e-3, 'rad/s by 2/5 m r²');
    },
  },
];

export const offsetRows: Row[] = [
  enabled(({ offset }) => offset),
  {
    field: 'translation',
    fact: 'another offset moves the shape in its body',
    run: async () => {
      const scene = await standing({ shape: [box(1)] }, {});
      const lifted = restsAt(scene, () => scene.offset.set('translation', [0, -1, 0]));
      close(lifted, 1.5, 1e-3, 'm, a metre below the origin');
      const unset = restsAt(scene, () => scene.offset.unset('translation'));
      close(unset, 0.5, 1e-3, 'm, unset');
    },
  },
  {
    field: 'rotation',
    fact: 'another rotation turns the shape in its body',
    run: async () => {
      const scene = await standing({ shape: [box(3, 1, 3)] }, {});
      const turned = restsAt(scene, () => scene.offset.set('rotation', [1, 0, 0, Math.PI / 2]));
      close(turned, 1.5, 2e-3, 'm, standing');
    },
  },
  {
    field: 'collidable',
    fact: 'another collidable, an offset in its turn, takes the place of the first',
    run: async () => {
      const scene = await standing({ shape: [box(1)] }, { translation: [0, -1, 0] });
      close(height(scene.body), 1.5, 1e-3, 'm');
      const { w } = scene;
      const inner = w.add('CollidableOffset', {
        translation: [0, -1, 0],
        collidable: { type: 'CollidableShape', shape: [sphere(0.7)] },
      });
      const deeper = restsAt(scene, () => scene.offset.set('collidable', inner));
      close(deeper, 2.7, 1e-3, 'm, offsets multiplied');
    },
  },
];
