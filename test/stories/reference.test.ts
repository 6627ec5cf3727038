import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { html, nothing } from 'lit';
import { kebab, tagOf } from '../../elements/bridge/words/dom.js';
import { allTypes } from '../../physics-core/all-types.js';
import { markupOf } from '../../stories/reference/markup.js';

const STORIES = new URL('../../stories/', import.meta.url);

for (const type of Object.values(allTypes)) {
  test(`${type.name} has a live story and a reference page`, () => {
    const story = readFileSync(new URL(`${kebab(type.name)}.stories.ts`, STORIES), 'utf8');
    assert.match(story, new RegExp(`title: 'Nodes/${type.name}',\\s+tags: \\['autodocs'\\]`));
    // Contacts have no element: page code gets them from a sensor.
    const shown = type.name === 'Contact' ? 'set_contacts' : `<${tagOf(type)}`;
    assert.ok(story.includes(shown), `its story shows ${shown}`);
  });
}

const story = html`<x3d>
  <scene>
    <viewpoint position="0 0 9"></viewpoint>
    <transform id="${'box'}" translation=${'0 1 0'} class=${nothing}>
      <shape><box size="1 1 1"></box></shape>
      <x3d-rigid-body id="body" fixed mass=${2} enabled=${true} @sleep=${() => {}}></x3d-rigid-body>
    </transform>
    <x3d-collision-collection
      collidables="*"
      appliedParameters='"SPEED-1" "SLIP-1"'
    ></x3d-collision-collection>
  </scene>
</x3d>`;

test("a story's markup is shown in HTML, without its camera and without what says nothing new", () => {
  assert.equal(
    markupOf(story).custom,
    `<transform id="box" translation="0 1 0">
  <shape>
    <box size="1 1 1"></box>
  </shape>
  <x3d-rigid-body id="body" fixed mass="2"></x3d-rigid-body>
</transform>
<x3d-collision-collection collidables="*" appliedParameters='"SPEED-1" "SLIP-1"'></x3d-collision-collection>`,
  );
});

test('an attribute that a story binds to true is shown bare, one bound to false is not there', () => {
  const body = (fixed: boolean) =>
    markupOf(html`<scene><x3d-rigid-body ?fixed=${fixed} mass="2"></x3d-rigid-body></scene>`);
  assert.equal(body(true).custom, '<x3d-rigid-body fixed mass="2"></x3d-rigid-body>');
  assert.equal(body(true).plain, '<RigidBody fixed="true" mass="2"/>');
  assert.equal(body(false).custom, '<x3d-rigid-body mass="2"></x3d-rigid-body>');
});

test('the same markup is shown in the names of X3D, as XML', () => {
  assert.equal(
    markupOf(story).plain,
    `<Transform DEF="box" translation="0 1 0">
  <Shape>
    <Box size="1 1 1"/>
  </Shape>
  <RigidBody DEF="body" fixed="true" mass="2"/>
</Transform>
<CollisionCollection collidables="*" appliedParameters='"SPEED-1" "SLIP-1"'/>`,
  );
});
