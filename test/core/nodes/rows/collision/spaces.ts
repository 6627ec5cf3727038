import assert from 'node:assert/strict';
import {
  addBody,
  box,
  claim,
  close,
  height,
  position,
  sphere,
  way,
  world,
  type Node,
} from '../../../helpers.js';
import type { Row } from '../row.js';

/** A ball above a fixed block, both in a collider by way of spaces: block > inner > outer > collider < ball. */
async function nested() {
  const w = await world();
  claim(w, 'not-in-collider');
  const block = w.add('CollidableShape', { shape: [box(2)] });
  const ball = w.add('CollidableShape', { shape: [sphere(0.5)] });
  const inner = w.add('CollisionSpace', { collidables: [block] });
  const outer = w.add('CollisionSpace', { collidables: [inner] });
  w.set('collider', w.add('CollisionCollection', { collidables: [outer, ball] }));
  addBody(w, { fixed: true, position: [0, -1, 0], geometry: [block] });
  const body = addBody(w, { position: [0, 0.5, 0], geometry: [ball] });
  addBody(w, { position: [50, 0, 0] });
  const holds = (expected: boolean, what: string): void => {
    body.event('position', [0, 0.5, 0]);
    body.event('linearVelocity', [0, 0, 0]);
    w.advance(0.5);
    close(height(body), expected ? 0.5 : 0.5 - way(9.8, 0.5), 2e-3, `m, ${what}`);
  };
  return { w, block, inner, outer, holds };
}

/** A table of one mesh: a top of 2 × 0.2 × 1 m on two legs, its feet 0.5 m below its origin. */
const slab = (x: number, y: number, halfX: number, halfY: number): number[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    x + (i & 1 ? halfX : -halfX),
    y + (i & 2 ? halfY : -halfY),
    i & 4 ? 0.5 : -0.5,
  ]);
const FACES = [
  0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7,
  1, 7, 5,
];
export const table = {
  type: 'IndexedTriangleSet',
  coord: [...slab(0, 0.4, 1, 0.1), ...slab(-0.9, -0.1, 0.1, 0.4), ...slab(0.9, -0.1, 0.1, 0.4)],
  index: [0, 8, 16].flatMap((first) => FACES.map((i) => i + first)),
};

/** How high the table comes to rest over a ball of 0.2 m that fits under it. */
function tableOver(w: Awaited<ReturnType<typeof world>>, shape: Node, ground: object) {
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
  const ball = addBody(w, { position: [0, 0.2, 0], geometry: [sphere(0.2)] });
  const body = addBody(w, { position: [0, 1.2, 0], geometry: [shape] });
  return { ball, body };
}

const flatGround = {
  type: 'IndexedTriangleSet',
  coord: [-9, 0.5, -9, 9, 0.5, -9, 9, 0.5, 9, -9, 0.5, 9],
  index: [0, 2, 1, 0, 3, 2],
};

export const spaceRows: Row[] = [
  {
    field: 'enabled',
    fact: 'a disabled space, at any depth, takes its collidables out of the collection',
    run: async () => {
      const { inner, outer, holds } = await nested();
      holds(true, 'both enabled');
      inner.set('enabled', false);
      holds(false, 'inner disabled');
      inner.set('enabled', true);
      holds(true, 'enabled again');
      outer.set('enabled', false);
      holds(false, 'outer disabled');
    },
  },
  {
    field: 'collidables',
    fact: 'members come and go, spaces within spaces too; a space within itself ends',
    run: async () => {
      const { w, block, inner, outer, holds } = await nested();
      inner.set('collidables', []);
      holds(false, 'taken out');
      inner.set('collidables', [outer, block]);
      holds(true, 'put back beside a circle');
      const other = w.add('CollisionSpace', { collidables: [block] });
      outer.set('collidables', [other]);
      inner.set('enabled', false);
      holds(true, 'by another space');
      other.remove();
      holds(false, 'that space removed');
    },
  },
  {
    field: 'collidables',
    fact: '`*` in a space means every collidable of the world, also those that come later, while it is enabled',
    run: async () => {
      const w = await world();
      claim(w, 'not-in-collider');
      const space = w.add('CollisionSpace', { collidables: '*' });
      w.set('collider', w.add('CollisionCollection', { collidables: [space] }));
      addBody(w, { fixed: true, position: [0, -1, 0], geometry: [box(2)] });
      w.step();
      const ball = addBody(w, { position: [0, 0.5, 0] });
      w.advance(0.5);
      close(height(ball), 0.5, 2e-3, 'm, held');
      space.set('enabled', false);
      w.advance(0.5);
      close(height(ball), 0.5 - way(9.8, 0.5), 0.02, 'm, the space is off');
      assert.equal(w.paused, false);
      assert.equal(space.get('collidables'), '*');
    },
  },
  {
    field: 'useGeometry',
    fact: 'a space of `*` takes every moving mesh by its own triangles',
    run: async () => {
      const w = await world();
      const space = w.add('CollisionSpace', { collidables: '*', useGeometry: true });
      w.add('CollisionCollection', { collidables: [space] });
      const shape = w.add('CollidableShape', { shape: [table] });
      const { ball, body } = tableOver(w, shape, flatGround);
      w.advance(1.5);
      close(height(body), 0.5, 0.02, 'm, on its feet');
      close(position(ball), [0, 0.2, 0], 0.02, 'm, under it');
    },
  },
  {
    field: 'useGeometry',
    fact: 'TRUE: a moving mesh stands on its own triangles, on meshes too; FALSE: it is its hull',
    run: async () => {
      for (const ground of [box(20, 1, 20), flatGround]) {
        const w = await world();
        claim(w, 'concave-dynamic');
        const shape = w.add('CollidableShape', { shape: [table] });
        const space = w.add('CollisionSpace', { collidables: [shape] });
        const { ball, body } = tableOver(w, shape, ground);
        w.advance(2);
        close(height(body) - height(ball), 0.7, 0.02, 'm, its hull on the ball');
        space.set('useGeometry', true);
        body.event('position', [0, 1.2, 0]);
        body.event('orientation', [0, 0, 1, 0]);
        body.event('angularVelocity', [0, 0, 0]);
        ball.event('position', [0, 0.2, 0]);
        ball.event('linearVelocity', [0, 0, 0]);
        w.advance(2);
        close(height(body), 0.5, 5e-3, 'm, on its feet');
        close(position(ball), [0, 0.2, 0], 5e-3, 'm, under it');
        assert.ok(!w.problems.some(({ code }) => code === 'concave-dynamic'));
        space.set('useGeometry', false);
        body.event('position', [0, 1.2, 0]);
        w.advance(1);
        close(height(body) - height(ball), 0.7, 0.02, 'm, its hull again');
      }
    },
  },
  {
    effect: 'pair filter',
    fact: 'one part of a body collides and its other part does not',
    run: async () => {
      const w = await world();
      const [inside, outside, ground] = [sphere(0.5), sphere(0.5), box(20, 1, 20)].map((shape) =>
        w.add('CollidableShape', { shape: [shape] }),
      );
      w.set('collider', w.add('CollisionCollection', { collidables: [inside, ground] }));
      addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
      const lower = { type: 'CollidableOffset', translation: [0, -1, 0], collidable: outside };
      const body = addBody(w, { position: [0, 2, 0], geometry: [inside, lower] });
      w.advance(2);
      close(height(body), 0.5, 2e-3, 'm, on its upper part');
    },
  },
];
