import { expect } from 'chai';
import { claim } from '../../console.js';
import { bothSpellings } from '../../forms.js';
import { show } from '../../scene.js';
import { worldOf, type World } from '../../inside.js';

describe('the version of a document', () => {
  const hinge = `<RigidBodyCollection id="c"><RigidBody DEF="a"></RigidBody>
    <SingleAxisHingeJoint DEF="h" body1="a"></SingleAxisHingeJoint></RigidBodyCollection>`;
  const axis = (world: { node(name: string): unknown }): number[] =>
    (world.node('h') as { asked(field: string): number[] }).asked('axis');

  it('is 4 where a page says none', async () => {
    const { world } = await show(hinge, '#c');
    expect(axis(world)).to.eql([0, 1, 0]);
  });

  it('gives X3D 3 its own defaults', async () => {
    claim('axis');
    document.body.innerHTML = `<x3d version="3.3" width="300px" height="200px"><scene>${hinge}</scene></x3d>`;
    const world = worldOf(document.querySelector('#c'))!;
    await world.ready;
    expect(axis(world)).to.eql([0, 0, 0]);
  });
});

describe('X3D 3 names of fields', () => {
  const source = `<ScalarInterpolator def="s" key="0 1" keyvalue="0.25 0.25"></ScalarInterpolator>
    <ROUTE fromNode="s" fromField="value_changed" toNode="j" toField="stopBounce1"></ROUTE>`;
  for (const [spelling, markup] of bothSpellings(`
    <x3d-rigid-body-collection id="c"><x3d-rigid-body id="a"></x3d-rigid-body>
      <x3d-double-axis-hinge-joint def="j" body1="a" stopbounce1="0.5"></x3d-double-axis-hinge-joint>
    </x3d-rigid-body-collection>`)) {
    const read = (world: World): unknown => (world.step(0), world.node('j')!.get('stop1Bounce'));

    it(`${spelling} tags: are the same fields as attributes`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      expect(read(world)).to.equal(0.5);
      const joint = x3d.querySelector('[def=j]')!;
      joint.setAttribute('stopbounce1', '0.75');
      expect(read(world)).to.equal(0.75);
      joint.removeAttribute('stopbounce1');
      expect(read(world)).to.equal(0);
      expect(world.problems).to.eql([]);
    });

    it(`${spelling} tags: are the same fields in ROUTEs`, async () => {
      const { x3d, world } = await show(markup + source, '#c');
      const { _x3domNode: node } = x3d.querySelector('[def=s]') as unknown as {
        _x3domNode: { _vf: Record<string, unknown>; fieldChanged(name: string): void };
      };
      node._vf.set_fraction = 1;
      node.fieldChanged('set_fraction');
      expect(read(world)).to.equal(0.25);
    });
  }
});
