import assert from 'node:assert/strict';
import { nodeTypes, World, type Field } from '../../physics-core/index.js';
import {
  addBody,
  close,
  closeWorlds,
  counts,
  fact,
  position,
  sphere,
  velocity,
  world,
  type Node,
} from './helpers.js';

/** Two valid values of a field, neither its default. */
function samples(field: Field, w: World): [unknown, unknown] {
  if (field.values) {
    const others = field.values.filter((value) => value !== field.default);
    return [others[0], others[1] ?? field.default];
  }
  const d = field.default as number & number[];
  const top = field.range && Number.isFinite(field.range[1]) ? field.range[1] : Infinity;
  const number = (share: number) => Math.min(top * share, 17 + share);
  switch (field.type) {
    case 'SFBool':
      return [!d, d];
    case 'SFFloat':
    case 'SFTime':
      return [number(0.3), number(0.6)];
    case 'SFInt32':
      return [2, 3];
    case 'SFString':
      return ['a', 'b'];
    case 'MFString':
      return [['SLIP_1'], ['SLIP_1', 'BOUNCE']];
    case 'SFVec2f':
      return [
        [0.1, 0.2],
        [0.3, 0.2],
      ];
    case 'SFVec3f':
      return [
        [0.1, 0.2, 0.3],
        [0.3, 0.2, 0.1],
      ];
    case 'SFRotation':
      return [
        [0, 1, 0, 0.5],
        [1, 0, 0, 0.5],
      ];
    case 'SFMatrix3f':
      return [
        [2, 0, 0, 0, 2, 0, 0, 0, 2],
        [3, 0, 0, 0, 3, 0, 0, 0, 3],
      ];
    case 'MFVec3f':
      return [[[1, 2, 3]], [[3, 2, 1]]];
    default: {
      const node = () => {
        const type = field.nodes?.[0] ?? 'Sphere';
        return nodeTypes[type]
          ? w.add(type)
          : { type, radius: Math.random() + 0.1, size: [1, 1, 1] };
      };
      return field.type === 'SFNode' ? [node(), node()] : [[node()], [node()]];
    }
  }
}

const copied = (value: unknown): unknown =>
  Array.isArray(value) && !(typeof value[0] === 'object' && !Array.isArray(value[0]))
    ? structuredClone(value)
    : value;

/** A node of the type among others it can work with. */
function made(w: World, type: string): Node {
  const body1 = addBody(w, { position: [0, 9, 0] });
  const fields: Record<string, Record<string, unknown>> = {
    RigidBody: { geometry: [w.add('CollidableShape', { shape: [sphere(0.5)] })] },
    CollidableShape: { shape: [sphere(0.5)] },
    BallJoint: { body1 },
    SingleAxisHingeJoint: { body1 },
    MotorJoint: { body1 },
  };
  if (type === 'RigidBodyCollection') return w.settings;
  const node = w.add(type, fields[type] ?? {});
  if (type === 'CollidableShape') addBody(w, { geometry: [node] });
  return node;
}

for (const [type, { fields }] of Object.entries(nodeTypes)) {
  for (const [name, field] of Object.entries(fields)) {
    if (field.access === 'outputOnly') continue;
    fact(
      `${type}.${name}: an edit patches and makes nothing, an equal value does nothing`,
      async () => {
        const w = await world({ rest: 'auto' });
        const node = made(w, type);
        const [first, second] = samples(field, w);
        w.step(2);
        const own = type === 'RigidBody' ? (node as ReturnType<typeof addBody>).pointer : 0;
        const at = (what: string, made: number, patched: number, edit: () => void) => {
          const before = counts(w);
          edit();
          const after = counts(w);
          assert.equal(after.patched - before.patched >= patched, true, `${what}: patched`);
          if (patched === 0) assert.equal(after.patched, before.patched, `${what}: patched`);
          assert.equal(after.created - before.created, made, `${what}: created`);
          if (made === 0) assert.equal(after.destroyed, before.destroyed, `${what}: destroyed`);
        };
        // Plain data becomes a node of its own: another object, not this one made again.
        const data = field.type === 'MFNode' && name === 'shape';
        at('a value', 0, 1, () => node.set(name, first));
        // What only takes events is an event each time.
        const always = data || field.access === 'inputOnly';
        if (!always) at('the equal value', 0, 0, () => node.set(name, copied(first)));
        at('another', 0, 1, () => node.set(name, second));
        at('an event of the same value', 0, field.access === 'initializeOnly' ? 0 : 1, () =>
          node.event(name, second),
        );
        at('the default', 0, 1, () => node.unset(name));
        at('the default again', 0, 0, () => node.unset(name));
        if (own) assert.equal((node as ReturnType<typeof addBody>).pointer, own);
        closeWorlds(false);
      },
    );
  }
}

fact(
  'a value equal to the one last asked for is no edit, even where the live value has moved on',
  async () => {
    const w = await world();
    const ball = addBody(w, { position: [0, 5, 0] });
    w.advance(0.5);
    const at = position(ball);
    for (let i = 0; i < 1000; i++) ball.set('position', [0, 5, 0]);
    w.step(0);
    close(position(ball), at, 0, 'm');
    ball.event('position', [0, 5, 0]);
    w.step(0);
    close(position(ball), [0, 5, 0], 0, 'm, an event always acts');
  },
);

fact('several fields edited together are one patch of each setter', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  w.step();
  const before = counts(w);
  ball.set('mass', 4);
  ball.set('linearVelocity', [1, 0, 0]);
  ball.set('linearVelocity', [2, 0, 0]);
  ball.set('forces', [[0, 4, 0]]);
  w.advance(1);
  close(velocity(ball), [2, 1, 0], 1e-4, 'm/s');
  assert.deepEqual(counts(w), { ...before, patched: before.patched + 3 });
});

fact('an edit before the node exists in Bullet counts as part of its creation', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  ball.set('linearVelocity', [1, 0, 0]);
  const { patched } = counts(w);
  assert.equal(patched, 0);
  w.advance(1);
  close(position(ball), [1, 0, 0], 1e-4, 'm');
});

fact('methods act on a body that was only just added', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const [pushed, moved] = [addBody(w), addBody(w, { position: [9, 0, 0] })];
  pushed.applyImpulse([2, 0, 0]);
  moved.teleport([0, 5, 0]);
  w.advance(1);
  close(position(pushed), [2, 0, 0], 1e-4, 'm');
  close(position(moved), [0, 5, 0], 1e-4, 'm');
});

fact('a body that was just added is where it starts, not where a default would be', async () => {
  const start = { p: [1, 2, 3], q: [0, 0, 0, 1] } as const;
  const w = await world({ gravity: [0, 0, 0] });
  w.step();
  const late = w.add('RigidBody', {}, { start: start as never });
  close(late.get('position') as number[], [1, 2, 3], 1e-6, 'm');
  w.paused = true;
  const early = new World();
  const waiting = early.add('RigidBody', {}, { start: start as never });
  close(waiting.get('position') as number[], [1, 2, 3], 1e-6, 'm, before the start');
  early.destroy();
});
