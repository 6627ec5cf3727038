import assert from 'node:assert/strict';
import { allTypes } from '../../../../physics-core/all-types.js';
import { createWorld } from '../../../../physics-core/create.js';
import { type World } from '../../../../physics-core/inside.js';
import {
  addBody,
  close,
  fact,
  position,
  random,
  way,
  type Body,
  type Node,
} from '../../../core/helpers.js';

const NUMBERS = [
  0,
  1,
  -1,
  0.5,
  7.5,
  1e-9,
  1e20,
  3e38,
  -3e38,
  1e39,
  1e300,
  NaN,
  Infinity,
  -Infinity,
];
const TEXTS = [
  '',
  'x',
  '*',
  '1 2 3',
  '1e39 0 0',
  'TRUE',
  'constructor',
  '0 1 0 1.5',
  'a'.repeat(500),
];
const GEOMETRY =
  'Box Sphere Cylinder Cone IndexedFaceSet IndexedTriangleSet TriangleStripSet QuadSet Torus Disk2D ElevationGrid Mesh';
const NAMES =
  'size radius height coord index points translation rotation linear stripCount shape collidable geometry constructor toString';
const types = Object.keys(allTypes).filter((type) => type !== 'RigidBodyCollection');

/** Whatever a careless or unlucky author may hand over, the same in every run. */
class Careless {
  readonly #next: () => number;
  readonly nodes: Node[] = [];

  constructor(seed: number) {
    this.#next = random(seed);
  }

  chance(share: number): boolean {
    return this.#next() < share;
  }

  one<T>(list: readonly T[]): T {
    return list[Math.floor(this.#next() * list.length)]!;
  }

  get numbers(): number[] {
    return Array.from({ length: Math.floor(this.#next() * 12) }, () => this.one(NUMBERS));
  }

  data(type: string, depth: number): Record<string, unknown> {
    const fields = [0, 1].map(() => [this.one(NAMES.split(' ')), this.value(depth + 1)]);
    return { ...Object.fromEntries(fields), type };
  }

  value(depth = 0): unknown {
    const kinds: (() => unknown)[] = [
      () => this.one(NUMBERS),
      () => this.one(TEXTS),
      () => this.one([null, undefined, true, false, Symbol('s'), 10n, () => 1]),
      () => [this.one(NUMBERS), this.one(NUMBERS), this.one(NUMBERS)],
      () => this.one([[1, 2, 3], [0, 1, 0, 1], [[1, 2, 3]], new Float32Array(3)] as unknown[]),
      () => this.numbers,
      () => this.one(this.nodes),
      () => [this.one(this.nodes), this.one(this.nodes)],
      () => this.one([new Map(), new Date(0), Object.create(null), itself()] as unknown[]),
    ];
    if (depth < 3)
      kinds.push(
        () => this.data(this.one(GEOMETRY.split(' ')), depth),
        () => [this.data(this.one(GEOMETRY.split(' ')), depth), this.value(depth + 1)],
        () => this.data(this.one(types), depth),
      );
    return this.one(kinds)();
  }
}

function itself(): object {
  const data: Record<string, unknown> = { type: 'CollidableOffset' };
  return Object.assign(data, { collidable: data, collidables: [data], size: data });
}

/** One edit, method or moment of a life. */
function act(w: World, by: Careless): void {
  const node = by.one(by.nodes);
  const field = by.chance(0.05) ? by.one(NAMES.split(' ')) : by.one(Object.keys(node.type.fields));
  by.one([
    () => node.set(field, by.value()),
    () => node.set(field, by.value()),
    () => node.event(field, by.value()),
    () => node.unset(field),
    () => void node.get(field),
  ])();
  if (by.chance(0.02)) w.reset();
  if (by.chance(0.02)) w.restore(w.snapshot());
  if (by.chance(0.03) && by.nodes.length > 9) by.nodes.pop()!.remove();
  if (!('teleport' in node) || by.chance(0.8)) return;
  const body = node as Body;
  body.teleport(by.value() as never, by.value() as never, by.value() as never);
  body.applyImpulse(by.value() as never, by.value() as never);
  body.drag(by.value() as never)?.cancel();
}

fact(
  'whatever data come in, nothing throws, every world steps on, and who has no part in it falls',
  async () => {
    const failures: unknown[] = [];
    for (let seed = 1; seed <= 12; seed++) {
      const [w, other] = [await createWorld({ rest: 'never' }), await createWorld()];
      w.on('problem', (problem) => {
        const { code, message } = problem as { code: string; message: string };
        if (['edit-failed', 'heap-exhausted'].includes(code)) failures.push(message);
        assert.doesNotMatch(message, /\[object|undefined is used|; *is used/);
        assert.ok(message.length < 500, message);
      });
      const by = new Careless(seed);
      const aside = addBody(w, { position: [1000, 0, 0] });
      by.nodes.push(addBody(w), addBody(other), w.add('CollisionCollection', { collidables: '*' }));
      for (let i = 0; i < 40; i++) {
        const type = by.one(types);
        const names = Object.keys(allTypes[type]!.fields);
        const fields = [0, 1, 2].map(() => [by.one(names), by.value()]);
        by.nodes.push(w.add(type, Object.fromEntries(fields)));
        for (let k = 0; k < 6; k++) act(w, by);
        w.step(2);
      }
      const { time } = w;
      assert.equal(w.paused, false);
      w.step(5);
      assert.ok(w.time > time);
      close(position(aside), [1000, -way(9.8, w.time), 0], 1e-2, 'm, aside');
      for (const each of [w, other]) each.destroy();
    }
    assert.deepEqual(failures, []);
  },
);
