import assert from 'node:assert/strict';
import { allTypes } from '../../../../physics-core/all-types.js';
import { addBody, claim, fact, world, told } from '../../helpers.js';

fact('names that every object of JavaScript has are no fields, node types or nodes', async () => {
  const w = await world();
  claim(w, 'unknown-attribute', 'no-body', 'bad-value');
  const names = ['constructor', 'toString', '__proto__', 'hasOwnProperty', 'valueOf'];
  for (const type of Object.keys(allTypes)) {
    const node = w.add(type);
    for (const name of names) {
      node.set(name, 1);
      node.event(name, 1);
      node.unset(name);
      assert.equal(node.get(name), undefined);
    }
    const found = w.problemsOf(node).map(({ code, attribute }) => [code, attribute]);
    assert.deepEqual(found, names.map((name) => ['unknown-attribute', name])); // prettier-ignore
    w.settle(node);
  }
  w.set('constructor', 1);
  for (const name of names) {
    assert.throws(() => w.add(name), /no node type/);
    assert.equal(w.node(name), undefined);
  }
  w.step();
});

fact('an unknown field is told with the one that was meant', async () => {
  const w = await world();
  claim(w, 'unknown-attribute');
  const ball = addBody(w, { linearvelocity: [1, 0, 0], masss: 2, weightOfTheThing: 3 });
  assert.deepEqual(told(w, 'unknown-attribute'), [
    'RigidBody has no field linearvelocity; did you mean linearVelocity?',
    'RigidBody has no field masss; did you mean mass?',
    'RigidBody has no field weightOfTheThing',
  ]);
  ball.set('x'.repeat(10_000), 1);
  assert.ok(told(w, 'unknown-attribute').every(({ length }) => length < 120));
});

fact('nobody is asked for by nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  assert.equal(w.node(undefined), undefined);
  assert.equal(w.node(null), undefined);
  assert.equal(w.node(ball.id), ball);
});
