import assert from 'node:assert/strict';
import { allTypes } from '../../../../physics-core/all-types.js';
import { provide } from '../../../../physics-core/nodes/node/advice-code.js';
import { NODES, WORDS, type Word } from '../../../../physics-core/nodes/node/words.js';
import { fact } from '../../helpers.js';

const KINDS = ['dynamic', 'static', 'fixed', 'kinematic'];
const words = Object.entries(WORDS).flatMap(([name, word]): [string, Word][] =>
  typeof word !== 'function'
    ? [[name, word]]
    : KINDS.map((kind): [string, Word | undefined] => [name, word(kind)]).filter(
        (each): each is [string, Word] => each[1] !== undefined,
      ),
);
const types = Object.keys(allTypes);

fact(
  'what a word of another engine is answered with is a field of the node that is named',
  async () => {
    assert.ok(words.length > 60);
    for (const [name, { field, at, node }] of words) {
      if (!field) continue;
      const owners = types.filter((type) => !at || at.test(type));
      const own = owners.filter((type) => Object.hasOwn(allTypes[type].fields, fieldOf(field)));
      assert.ok(at ? own.length === owners.length : own.length > 0, `${name}: ${field} of ${node}`);
    }
  },
);

/** Ours are written in kebab case. */
const fieldOf = (attribute: string): string =>
  attribute.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase());

fact('what is to be written is written with fields of the body', async () => {
  for (const [name, { write = '' }] of words)
    for (const [, field] of write.matchAll(/(\w+)="/g))
      assert.ok(
        ['RigidBody', 'RigidBodyCollection'].some((type) => field in allTypes[type].fields),
        `${name}: ${field}`,
      );
});

fact('a tag is answered with a node that there is', async () => {
  const { meantNode } = provide();
  for (const node of Object.values(NODES)) assert.ok(node!.type! in allTypes, node!.type);
  for (const [tag, type] of [
    ['x3d-rigidbody', 'RigidBody'],
    ['x3d-ridgid-body', 'RigidBody'],
    ['x3d-hinge-joint', 'SingleAxisHingeJoint'],
    ['HingeJoint', 'SingleAxisHingeJoint'],
    ['x3d-collider', 'CollidableShape'],
    ['x3d-bal-joint', 'BallJoint'],
    ['x3d-zeppelin', undefined],
    ['constructor', undefined],
  ])
    assert.equal(meantNode(tag!, types)?.type, type, tag);
});
