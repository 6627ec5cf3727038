import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../elements/index.js';
import { explain } from '../../../elements/index.js';
import { claim } from '../console.js';
import { bothSpellings } from './forms.js';
import { drawn, drawnAt, place, show, until, wait } from './scene.js';
import { worldOf, type World } from '../inside.js';

type Runtime = { createX3DFromString(text: string): Element };

const position = (world: { node(name: string): unknown }, name: string): number[] =>
  (world.node(name) as { get(field: string): number[] }).get('position');

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

  it('of an Inline is that of its file', async () => {
    const x3d = place('<inline url="/test/pages/version3.x3d"></inline>');
    const ready = new Promise<CustomEvent>((resolve) =>
      x3d.addEventListener('physicsready', (event) => resolve(event as CustomEvent)),
    );
    claim('axis');
    const { detail } = await ready;
    expect(axis(worldOf(detail.element)!)).to.eql([0, 0, 0]);
    await wait(1100);
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

describe('for on a collidable', () => {
  for (const [spelling, markup] of bothSpellings(`
    <transform id="t" translation="1 2 3"><shape><sphere radius="0.5"></sphere></shape></transform>
    <transform id="u" translation="9 8 7"><shape><box></box></shape></transform>
    <x3d-rigid-body-collection id="c"><x3d-rigid-body id="b">
      <x3d-collidable-shape id="s" for="t"></x3d-collidable-shape></x3d-rigid-body></x3d-rigid-body-collection>`))
    it(`${spelling} tags: changed at run time moves its body to the new Transform`, async () => {
      const { x3d, world } = await show(markup, '#c');
      world.paused = true;
      world.reset();
      expect(position(world, 'b')).to.eql([1, 2, 3]);
      x3d.querySelector('#s')!.setAttribute('for', 'u');
      world.step(0);
      expect(position(world, 'b')).to.eql([9, 8, 7]);
      const [shape] = world.node('b')!.get('geometry') as {
        get(name: string): { type: string }[];
      }[];
      expect(shape!.get('shape')[0]!.type).to.equal('Box');
      world.advance(0.5);
      await drawn();
      expect(drawnAt(x3d.querySelector('#u')!)[1]).to.be.closeTo(position(world, 'b')[1]!, 0.05);
      expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(2, 1e-5);
    });
});

describe('nodes as properties', () => {
  it('name elements in the place of children, and give them back', async () => {
    claim('no-body');
    const { x3d, world } = await show(
      `<x3d-collidable-shape id="s"><shape><sphere></sphere></shape></x3d-collidable-shape>
       <x3d-rigid-body-collection id="c"><x3d-rigid-body id="a"></x3d-rigid-body><x3d-rigid-body id="b" position="3 0 0"></x3d-rigid-body>
         <x3d-ball-joint id="j"></x3d-ball-joint></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    const find = (id: string): never => x3d.querySelector(`#${id}`)! as never;
    const body = find('a') as { geometry: unknown };
    body.geometry = [find('s')];
    world.step(0);
    expect(body.geometry).to.eql([find('s')]);
    expect((world.node('a')!.get('geometry') as unknown[]).length).to.equal(1);
    const joint = find('j') as { body1: unknown; body2: unknown };
    Object.assign(joint, { body1: find('a'), body2: find('b') });
    world.step(0);
    expect([joint.body1, joint.body2]).to.eql([find('a'), find('b')]);
    expect(world.stats.joints).to.equal(1);
    body.geometry = null;
    joint.body2 = null;
    world.step(0);
    expect(body.geometry).to.eql([]);
    expect(joint.body2).to.equal(null);
  });
});

describe('the world in a page', () => {
  const scene = `
    <transform translation="0 3 0"><shape><sphere radius="0.5"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>
    <x3d-rigid-body-collection id="c" default></x3d-rigid-body-collection>`;

  it('raycast tells the element that is hit, and null of nothing', async () => {
    const { x3d, world } = await show(scene, '#c');
    world.paused = true;
    world.reset();
    const hit = world.raycast([0, 10, 0], [0, -10, 0]) as { element: Element; position: number[] };
    expect(hit.element).to.equal(x3d.querySelector('#ball'));
    expect(hit.position[1]).to.be.closeTo(3.5, 1e-3);
    expect(world.raycast([5, 10, 0], [5, -10, 0])).to.equal(null);
  });

  it('snapshot and restore take what is drawn and what elements say along', async () => {
    const { x3d, world } = await show(scene, '#c');
    world.paused = true;
    world.reset();
    world.advance(0.5);
    const snapshot = world.snapshot();
    const ball = x3d.querySelector<X3DRigidBodyElement>('#ball')!;
    const before = ball.position;
    const runs = [1, 2].map(() => {
      world.restore(snapshot);
      expect(ball.position).to.eql(before);
      world.advance(0.5);
      return ball.position;
    });
    expect(runs[0]).to.eql(runs[1]);
    world.restore(snapshot);
    expect(world.time).to.be.closeTo(0.5, 1e-9);
    await drawn();
    expect(drawnAt(x3d.querySelector('transform')!)[1]).to.be.closeTo(before[1]!, 1e-4);
  });

  it('a problem of the world shows at its collection until it is settled', async () => {
    const { x3d, world } = await show(scene, '#c');
    const collection = x3d.querySelector('#c')!;
    claim('[something]');
    world.report({ code: 'something', severity: 'info', message: 'said' });
    expect(collection.matches(':state(problem)')).to.equal(true);
    world.settle(world, undefined, 'something');
    expect(collection.matches(':state(problem)')).to.equal(false);
  });

  it('explain says why a body sleeps', async () => {
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c" autodisable="true" disablelinearspeed="1" disableangularspeed="1">
        <x3d-rigid-body id="b" useglobalgravity="false"></x3d-rigid-body></x3d-rigid-body-collection>`,
      '#c',
    );
    world.paused = true;
    const body = x3d.querySelector<X3DRigidBodyElement>('#b')!;
    world.advance(0.5);
    expect(explain(body).sleeps).to.match(/^autoDisable/);
    body.wake();
    expect(explain(body).sleeps).to.equal(undefined);
  });
});
