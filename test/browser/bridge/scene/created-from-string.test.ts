import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { place, until, position } from '../../scene.js';
import { worldOf } from '../../inside.js';

type Runtime = { createX3DFromString(text: string): Element };

describe('createX3DFromString', () => {
  for (const [spelling, body] of bothSpellings(`
    <x3d-rigid-body-collection DEF="c"><x3d-rigid-body DEF="b" position="0 5 0" linearVelocity="1 0 0">
      <x3d-collidable-shape DEF="s"><Shape><Sphere radius="0.5"/></Shape></x3d-collidable-shape>
    </x3d-rigid-body></x3d-rigid-body-collection>`))
    it(`${spelling} tags: what it makes simulates once it stands in the scene`, async () => {
      // Tags of a foreign document are no custom elements.
      if (spelling === 'custom') claim('not-upgraded');
      const x3d = place('');
      const { runtime } = x3d as unknown as { runtime?: Runtime };
      await until(() => (x3d as unknown as { runtime?: Runtime }).runtime !== undefined);
      const made = (
        (x3d as unknown as { runtime: Runtime }).runtime ?? runtime
      ).createX3DFromString(`<?xml version="1.0"?><X3D version="4.0"><Scene>${body}</Scene></X3D>`);
      const collection = [...made.querySelectorAll('*')].find(
        (each) => Element.prototype.getAttribute.call(each, 'DEF') === 'c',
      )!;
      x3d.querySelector('scene')!.append(collection);
      const world = worldOf(collection)!;
      await world.ready;
      world.paused = true;
      world.reset();
      world.advance(1);
      expect(position(world, 'b')[0]).to.be.closeTo(1, 0.01);
      expect(position(world, 'b')[1]).to.be.closeTo(5 - 4.9, 0.05);
    });
});
