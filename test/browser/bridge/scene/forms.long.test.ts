import { expect } from 'chai';
import type { X3DRigidBodyElement } from '../../../../elements/index.js';
import { worldOf } from '../../../../elements/index.js';
import '../../console.js';
import { drawn, drawnAt, nextFrame, place, position, show, until, wait } from '../../scene.js';

const field = (element: Element, name: string): { x: number; y: number; z: number } =>
  (
    element as unknown as { getFieldValue(name: string): { x: number; y: number; z: number } }
  ).getFieldValue(name);

describe('plain tags', () => {
  it('move like custom ones', async () => {
    const { x3d, world } = await show(`
      <RigidBodyCollection>
        <RigidBody DEF="floor" fixed="true" position="0 -0.5 0">
          <CollidableShape><Shape><Box size="10 1 10"></Box></Shape></CollidableShape>
        </RigidBody>
        <RigidBody DEF="ball" position="0 3 0"><CollidableShape USE="ballshape"></CollidableShape></RigidBody>
      </RigidBodyCollection>
      <CollidableShape DEF="ballshape"><Shape><Sphere radius="0.5"></Sphere></Shape></CollidableShape>`);
    world.paused = true;
    world.advance(3);
    const ball = x3d.querySelector('[def=ball]')!;
    expect(field(ball, 'position').y).to.be.closeTo(0.5, 0.02);
    await nextFrame();
    await nextFrame();
    expect(drawnAt(x3d.querySelector('[def=ballshape]')!)[1]).to.be.closeTo(0.5, 0.02);
  });

  it('take edits of their attributes before the next step', async () => {
    const { x3d, world } = await show(
      `<RigidBodyCollection><RigidBody DEF="b"></RigidBody></RigidBodyCollection>`,
    );
    world.paused = true;
    const body = x3d.querySelector('[def=b]')!;
    body.setAttribute('linearVelocity', '1 0 0');
    world.step(1);
    expect(world.node('b')!.get('linearVelocity')).to.have.property('0').closeTo(1, 1e-6);
    body.setAttribute('position', '0 7 0');
    expect(field(body, 'position').y).to.equal(7);
  });

  it('send and take ROUTEs', async () => {
    const { x3d, world } = await show(`
      <RigidBodyCollection><RigidBody DEF="b" position="0 5 0"></RigidBody></RigidBodyCollection>
      <Transform DEF="t"></Transform><Transform DEF="src"></Transform>
      <RigidBodyCollection><RigidBody DEF="c" useGlobalGravity="false"></RigidBody></RigidBodyCollection>
      <ROUTE fromNode="b" fromField="position" toNode="t" toField="translation"></ROUTE>
      <ROUTE fromNode="t" fromField="translation_changed" toNode="c" toField="set_position"></ROUTE>`);
    await until(() => position(world, 'b')[1]! < 4.8);
    world.paused = true;
    const y = position(world, 'b')[1]!;
    const c = worldOf(x3d.querySelector('[def=c]')!)!.node('c')!;
    await until(() => Math.abs((c.get('position') as number[])[1]! - y) < 1e-3);
    expect(field(x3d.querySelector('[def=t]')!, 'translation').y).to.be.closeTo(y, 1e-3);
  });
});

describe('shortcuts', () => {
  it('a body inside a Transform drives it and collides with its Shapes', async () => {
    const { x3d, world } = await show(
      `
      <transform><shape><box size="10 1 10"></box></shape><x3d-rigid-body fixed="true"></x3d-rigid-body></transform>
      <transform translation="1 0 0" scale="2 2 2">
        <transform id="t" translation="0 3 0"><shape><sphere radius="0.5"></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>
      </transform>`,
      '#ball',
    );
    world.paused = true;
    const ball = x3d.querySelector<X3DRigidBodyElement>('#ball')!;
    expect(ball.position).to.eql([1, 6, 0]);
    world.advance(4);
    await nextFrame();
    await nextFrame();
    const shown = drawnAt(x3d.querySelector('#t')!);
    expect(shown[0]).to.be.closeTo(1, 0.01);
    expect(shown[1]).to.be.closeTo(1.5, 0.03);
    expect(field(x3d.querySelector('#t')!, 'translation').y).to.be.closeTo(0.75, 0.03);
  });

  it('for names the Transform from elsewhere', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t" translation="0 3 0"><shape><sphere radius="0.5"></sphere></shape></transform>
      <x3d-rigid-body id="ball" for="t"></x3d-rigid-body>`,
      '#ball',
    );
    world.paused = true;
    world.step(60);
    await nextFrame();
    await nextFrame();
    expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(3 - 4.9 * 0.25, 0.05);
  });

  it('an edit of the Transform teleports the body', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`,
      '#ball',
    );
    world.paused = true;
    await nextFrame();
    x3d.querySelector('#t')!.setAttribute('translation', '4 5 6');
    await nextFrame();
    expect(x3d.querySelector<X3DRigidBodyElement>('#ball')!.position).to.eql([4, 5, 6]);
  });
});

describe('late things', () => {
  it('a body appended later joins the running world', async () => {
    const { x3d, world } = await show(
      `<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>`,
    );
    const body = document.createElement('x3d-rigid-body');
    body.setAttribute('position', '0 9 0');
    x3d.querySelector('#c')!.append(body);
    expect(worldOf(body)).to.equal(world);
    world.step(0);
    expect(world.stats.bodies).to.equal(1);
    body.remove();
    world.step(0);
    expect(world.stats.bodies).to.equal(0);
  });

  it('an x3d put back goes on', async () => {
    const { x3d } = await show(
      `
      <transform id="t" translation="0 3 0"><shape><sphere></sphere></shape><x3d-rigid-body id="ball"></x3d-rigid-body></transform>`,
      '#ball',
    );
    x3d.remove();
    await wait(50);
    document.body.append(x3d);
    const world = worldOf(x3d.querySelector('#ball')!)!;
    await world.ready;
    world.paused = true;
    world.advance(1);
    await nextFrame();
    await nextFrame();
    expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.below(0);
  });
});

/** Their Shapes stand in bodies only, which draw nothing. */
const UNDRAWN = new Set(['settling-crate']);

/** The longest way from one list of places to another. */
const farthest = (from: number[][], to: number[][]): number =>
  Math.max(...from.map((place, i) => Math.hypot(...place.map((value, j) => value - to[i]![j]!))));

describe('Inline', () => {
  for (const file of ['ball', 'settling-crate', 'swinging-lamps']) {
    it(`${file}.x3d starts and moves`, async () => {
      const x3d = place(`<inline url="/test/pages/${file}.x3d"></inline>`);
      const event = await new Promise<CustomEvent>((resolve) =>
        x3d.addEventListener('physicsready', (ready) => resolve(ready as CustomEvent)),
      );
      expect(event.target).to.equal(x3d.querySelector('inline'));
      const world = worldOf(event.detail.element)!;
      world.paused = true;
      world.reset();
      const movable = [...world.nodes].filter(
        (node) => node.type.name === 'RigidBody' && !node.get('fixed'),
      );
      const places = (): number[][] => movable.map((node) => node.get('position') as number[]);
      const pictures = [
        ...event.detail.element.ownerDocument.querySelectorAll(
          'CollidableShape, CollidableOffset, Transform',
        ),
      ].filter((element) => '_x3domNode' in element);
      await drawn();
      const [stood, shown] = [places(), pictures.map(drawnAt)];
      world.advance(1);
      await drawn();
      expect(world.stats.bodies).to.be.greaterThan(1);
      const way = farthest(stood, places());
      expect(way).to.be.greaterThan(0.05);
      const seen = farthest(shown, pictures.map(drawnAt));
      if (UNDRAWN.has(file)) expect(seen).to.equal(0);
      else expect(seen).to.be.greaterThan(0.05);
      expect(world.problems).to.eql([]);
    });
  }
});
