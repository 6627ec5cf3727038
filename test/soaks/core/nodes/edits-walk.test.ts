import assert from 'node:assert/strict';
import { test } from 'node:test';
import { allTypes } from '../../../../physics-core/all-types.js';
import type { PhysicsNode, World } from '../../../../physics-core/inside.js';
import { BodyNode } from '../../../../physics-core/nodes/body/body.js';
import { openInCore } from '../../../conformance/core-driver.js';
import type { Fact, NodeData } from '../../../conformance/fact.js';
import { nodesIn } from '../../../conformance/markup.js';
import { plain } from '../../../conformance/plain.js';
import { scene, SECONDS, SPARES, SUBJECTS } from '../../../edits/scene.js';
import { editOf } from '../../../edits/table.js';
import { ALL_FIELDS, walkField, type Editor } from '../../../edits/walk.js';

// Tests count steps, not milliseconds: a busy machine must not make a frame drop any.
performance.now = () => 0;

const nodeOf = (world: World, name: string): PhysicsNode =>
  world.settings.name === name ? world.settings : world.node(name)!;

/** Nodes by their names, and what is no node of physics as plain data. */
function named(world: World, value: unknown, many: boolean): unknown {
  const nodes = nodesIn(value) as NodeData[] | undefined;
  if (!nodes) return value;
  const found = nodes.map(({ USE }) => SPARES[USE!] ?? nodeOf(world, USE!));
  return many ? found : found[0];
}

async function edited(type: string) {
  const stage = await openInCore({ scene: scene(type) } as Fact);
  const world = stage.worlds[0]!;
  world.advance(SECONDS);
  const with_ = (subject: string, field: string, value: unknown) => {
    const node = nodeOf(world, subject);
    return { node, value: named(world, value, node.type.fields[field]!.type === 'MFNode') };
  };
  const editor: Editor = {
    world,
    hasMarkup: () => false,
    keeps: () => false,
    read: (subject, field) => plain(nodeOf(world, subject).get(field)),
    told: () => stage.told.splice(0),
    set: (subject, field, given) => {
      const { node, value } = with_(subject, field, given);
      node.set(field, value);
    },
    unset: (subject, field) => nodeOf(world, subject).unset(field),
    event: (subject, field, given) => {
      const { node, value } = with_(subject, field, given);
      node.event(field, value);
      return true;
    },
  };
  return { editor, close: () => stage.close() };
}

let walked = 0;

for (const [type, field] of ALL_FIELDS) {
  test(`${type}.${field}: an edit changes what the table says, and nothing else`, async () => {
    const { editor, close } = await edited(type);
    assert.deepEqual(walkField(type, field, editor), []);
    walked++;
    await close();
  });
}

/** Damping is felt in motion only, and dragging by who is dragged; the others are kept. */
const SLEEPS_ON = new Set([
  ...['autoDamp', 'linearDampingFactor', 'angularDampingFactor', 'dragMode', 'draggableBody'],
  ...Object.entries(allTypes.RigidBody!.fields)
    .filter(([, { edit }]) => edit === 'passive')
    .map(([name]) => name),
]);

for (const name of Object.keys(allTypes.RigidBody!.fields))
  test(`RigidBody.${name}: an edit ${SLEEPS_ON.has(name) ? 'lets a sleeping body sleep' : 'wakes a sleeping body'}, and nobody else`, async () => {
    const { editor, close } = await edited('RigidBody');
    const { given = {}, values } = editOf('RigidBody', name)!;
    const bodies = [...editor.world.nodes].filter((node) => node instanceof BodyNode);
    const asleep = () => bodies.filter(({ sleeping }) => sleeping).map((body) => body.name);
    assert.deepEqual(asleep(), ['stone']);
    for (const [field, value] of Object.entries(given)) editor.set('stone', field, value);
    editor.world.step(0);
    (nodeOf(editor.world, 'stone') as BodyNode).sleep();
    editor.set('stone', name, values[name === 'autoDisable' ? 1 : 0]);
    editor.world.step(0);
    assert.deepEqual(asleep(), SLEEPS_ON.has(name) ? ['stone'] : []);
    await close();
  });

test('as many fields were walked as stand in the tables of all node types', () => {
  const all = Object.values(allTypes).map(({ fields }) => Object.keys(fields).length);
  assert.equal(
    walked,
    all.reduce((sum, count) => sum + count, 0),
  );
  assert.deepEqual(Object.keys(SUBJECTS).sort(), Object.keys(allTypes).sort());
});
