import assert from 'node:assert/strict';
import { allTypes } from '../../../physics-core/all-types.js';
import { fact, world } from '../helpers.js';

fact('a node of an X3D 3 file has the defaults of its version, and gets them back', async () => {
  const w = await world();
  const fields = Object.entries(allTypes).flatMap(([type, node]) =>
    Object.entries(node.fields)
      .filter(([, field]) => field.default3 !== undefined)
      .map(([name, field]) => ({ type, name, field })),
  );
  for (const { type, name, field } of fields) {
    const [old, now] = [3.3, undefined].map((version) => w.add(type, {}, { version }));
    assert.deepEqual(old!.get(name), field.default3, `${type}.${name}`);
    assert.deepEqual(now!.get(name), field.default, `${type}.${name}`);
    old!.set(name, field.default);
    assert.deepEqual(old!.get(name), field.default);
    old!.unset(name);
    assert.deepEqual(old!.get(name), field.default3);
  }
});

fact('every node has metadata, bounded ones a bounding box, and two a description', async () => {
  for (const [type, { fields }] of Object.entries(allTypes)) {
    assert.equal(fields['metadata']?.type, 'SFNode', type);
    const bounded =
      /^(RigidBody|Rope|Cloth)|SoftBody$|Collidable|Collision(?!Sensor)|ParticleSystem|WaterVolume/.test(
        type,
      );
    for (const name of ['bboxCenter', 'bboxSize', 'bboxDisplay', 'visible'])
      assert.equal(name in fields, bounded, `${type}.${name}`);
    assert.equal('description' in fields, /Collision(Collection|Sensor)/.test(type), type);
  }
});

fact('plain data in a field has the version of the node it stands in', async () => {
  const w = await world();
  const body = w.add('RigidBody', { geometry: [{ type: 'Sphere' }] }, { version: 3 });
  const [collidable] = body.get('geometry') as (typeof body)[];
  assert.equal(collidable!.version, 3);
  assert.equal(w.add('RigidBody').version, 4);
});
