import { executeServerCommand } from '@web/test-runner-commands';
import { expect } from 'chai';
import { worldOf } from '../../../../elements/index.js';
import { claim } from '../../console.js';
import { drawn, drawnAt, place, until } from '../../scene.js';

// What the Elements panel of Chromium's devtools sends when somebody works in it.

const inChromium = 'userAgentData' in navigator;

const send = (method: string, params: object = {}): Promise<Record<string, number>> =>
  executeServerCommand('devtools', { method: `DOM.${method}`, params });

/** One action of somebody at the panel, which may be undone: on one element, and perhaps onto another. */
async function act(
  method: string,
  selector: string,
  params: object = {},
  target?: string,
): Promise<void> {
  // Asked for anew the document has other numbers for its nodes.
  const { root } = (await send('getDocument')) as unknown as { root: { nodeId: number } };
  const numberOf = async (wanted: string): Promise<number> =>
    (await send('querySelector', { nodeId: root.nodeId, selector: wanted })).nodeId!;
  const targetNodeId = target && (await numberOf(target));
  const nodeId = await numberOf(selector);
  await send('markUndoableState');
  await send(method, { nodeId, ...params, ...(target && { targetNodeId }) });
}

const scene = `
  <x3d-rigid-body-collection id="world">
    <x3d-rigid-body id="swing" mass="2" position="1 5 0" linearVelocity="0 0 2">
      <x3d-collidable-shape id="shape"><shape><box id="box" size="0.4 0.4 0.4"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>
    <x3d-ball-joint id="joint" body1="swing" anchorPoint="0 5 0"></x3d-ball-joint>
  </x3d-rigid-body-collection>
  <group id="group">
    <transform id="t" translation="5 5 0"><shape><sphere radius="0.5"></sphere></shape>
      <x3d-rigid-body id="free" linearVelocity="1 0 0"></x3d-rigid-body></transform>
  </group>
  <transform id="other" translation="0 1 0"></transform>`;

interface Body {
  pointer: number;
  get(field: string): any;
}

/** The scene after a quarter of a second, at rest until somebody steps. */
async function show() {
  const x3d = place(scene);
  const [world, free] = ['#swing', '#free'].map((name) => worldOf(x3d.querySelector(name)!)!);
  await Promise.all([world!.ready, free!.ready]);
  for (const each of [world!, free!]) {
    each.paused = true;
    each.reset();
    each.advance(0.25);
  }
  await drawn();
  return { x3d, world: world!, free: free! };
}

type World = Awaited<ReturnType<typeof show>>['world'];

const bodyOf = (world: World, name: string) => world.node(name) as unknown as Body;

/** Which Bullet object a body is, where it is, and how it moves. */
const stateOf = (world: World, name: string) => {
  const body = bodyOf(world, name);
  const [position, velocity] = [body.get('position'), body.get('linearVelocity')] as number[][];
  const round = (value: number): number => Math.round(value * 1e5) / 1e5;
  return { object: body.pointer, position: position!.map(round), velocity: velocity!.map(round) };
};

const counts = (world: World): number[] => {
  world.step(0);
  const { bodies, joints, created, patched, destroyed } = world.stats;
  return [bodies, joints, created, patched, destroyed];
};

/** What an action adds to bodies, joints, and to what was created, patched and destroyed. */
async function added(world: World, action: () => Promise<unknown>): Promise<number[]> {
  const before = counts(world);
  await action();
  return counts(world).map((count, i) => count - before[i]!);
}

// Only Chromium's driver lends its DevTools session to a test.
(inChromium ? describe : describe.skip)('somebody at the devtools', () => {
  before(() => send('enable'));

  it('edits an attribute, undoes it, does it again: the same body, where it was', async () => {
    const { world } = await show();
    const before = stateOf(world, 'swing');
    const mass = (): number => bodyOf(world, 'swing').get('mass');
    const edit = () => act('setAttributeValue', '#swing', { name: 'mass', value: '5' });
    expect(await added(world, edit)).to.eql([0, 0, 0, 1, 0]);
    expect(mass()).to.equal(5);
    expect(await added(world, () => send('undo'))).to.eql([0, 0, 0, 1, 0]);
    expect(mass()).to.equal(2);
    expect(await added(world, () => send('redo'))).to.eql([0, 0, 0, 1, 0]);
    expect(mass()).to.equal(5);
    expect(stateOf(world, 'swing')).to.eql(before);
  });

  it('types several attributes at once, and takes one away', async () => {
    const { world } = await show();
    const before = stateOf(world, 'swing');
    const body = bodyOf(world, 'swing');
    const type = () =>
      act('setAttributesAsText', '#swing', { text: 'mass="4" autoDamp="true"', name: 'mass' });
    expect(await added(world, type)).to.eql([0, 0, 0, 2, 0]);
    expect([body.get('mass'), body.get('autoDamp')]).to.eql([4, true]);
    const remove = () => act('removeAttribute', '#swing', { name: 'mass' });
    expect(await added(world, remove)).to.eql([0, 0, 0, 1, 0]);
    expect(body.get('mass')).to.equal(1);
    expect(stateOf(world, 'swing')).to.eql(before);
  });

  it('edits as HTML: what is still there is patched, not made again', async () => {
    // Chromium writes every attribute anew, also those of a body that has moved on.
    claim('position="1 5 0" is what it was last set to', 'linearVelocity="0 0 2" is what it was');
    const { x3d, world } = await show();
    const before = stateOf(world, 'swing');
    const shape = x3d.querySelector('#shape');
    const outerHTML = `<x3d-rigid-body id="swing" mass="3" position="1 5 0" linearVelocity="0 0 2">
      <x3d-collidable-shape id="shape"><shape><box id="box" size="0.4 0.8 0.4"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>`;
    const [bodies, joints, made, , destroyed] = await added(world, () =>
      act('setOuterHTML', '#swing', { outerHTML }),
    );
    expect([bodies, joints]).to.eql([0, 0]);
    expect(x3d.querySelector('#shape')).to.equal(shape);
    expect(bodyOf(world, 'swing').get('mass')).to.equal(3);
    expect(stateOf(world, 'swing')).to.eql(before);
    // Plain data in a Shape's place is no node: nothing is made but that.
    expect([made, destroyed]).to.eql([0, 0]);
  });

  it('deletes a body and undoes that: it starts from its markup, and its joint holds it again', async () => {
    const { world } = await show();
    claim('waits for body1 "swing"');
    const remove = () => act('removeNode', '#swing');
    expect((await added(world, remove)).slice(0, 2)).to.eql([-1, -1]);
    world.step(10);
    expect((await added(world, () => send('undo'))).slice(0, 2)).to.eql([1, 1]);
    expect(stateOf(world, 'swing').position).to.eql([1, 5, 0]);
    world.advance(0.5);
    const [x, y, z] = bodyOf(world, 'swing').get('position') as number[];
    expect(Math.hypot(x!, y! - 5, z!)).to.be.closeTo(1, 1e-3);
  });

  it('drags a Transform elsewhere in the tree: the same body goes on as it was', async () => {
    const { x3d, free } = await show();
    const before = stateOf(free, 'free');
    const move = () => act('moveTo', '#t', {}, '#other');
    expect(await added(free, move)).to.eql([0, 0, 0, 0, 0]);
    expect(x3d.querySelector('#other #free')).not.to.equal(null);
    expect(stateOf(free, 'free')).to.eql(before);
    await until(() => Math.abs(drawnAt(x3d.querySelector('#t')!)[1]! - before.position[1]!) < 1e-4);
    await send('undo');
    expect(stateOf(free, 'free')).to.eql(before);
  });

  it('duplicates a body: the copy starts from its markup, the first goes on as it was', async () => {
    const { x3d, free } = await show();
    const before = stateOf(free, 'free');
    const copy = () => act('copyTo', '#t', {}, '#group');
    expect((await added(free, copy)).slice(0, 2)).to.eql([1, 0]);
    const bodies = [...x3d.querySelectorAll('#free')].map(
      (element) => free.node(element) as unknown as Body,
    );
    const places = bodies.map((body) => Math.round(body.get('position')[0] * 100) / 100);
    expect(places).to.have.members([5, 5.25]);
    expect(bodies[places.indexOf(5.25)]!.pointer).to.equal(before.object);
    expect((await added(free, () => send('undo'))).slice(0, 2)).to.eql([-1, 0]);
    expect(stateOf(free, 'free')).to.eql(before);
  });

  it('edits what is seen: a Transform teleports its body, a size reshapes it', async () => {
    const { free } = await show();
    const before = stateOf(free, 'free');
    await act('setAttributeValue', '#t', { name: 'translation', value: '0 9 0' });
    expect(stateOf(free, 'free')).to.eql({ ...before, position: [0, 9, 0] });
    await act('setAttributeValue', '#t sphere', { name: 'radius', value: '2' });
    free.step(0);
    expect(free.raycast([0, 20, 0], [0, 0, 0])!.position[1]).to.be.closeTo(11, 1e-3);
    await send('undo');
    free.step(0);
    expect(free.raycast([0, 20, 0], [0, 0, 0])!.position[1]).to.be.closeTo(9.5, 1e-3);
    expect(stateOf(free, 'free').object).to.equal(before.object);
  });

  it('deletes the whole x3d and undoes that: it draws and simulates again, on one canvas', async () => {
    const { x3d } = await show();
    await act('removeNode', 'x3d');
    await drawn();
    await send('undo');
    const world = worldOf(x3d.querySelector('#swing')!)!;
    await world.ready;
    await until(() => x3d.querySelectorAll('canvas').length === 1);
    world.paused = true;
    world.reset();
    world.advance(0.25);
    expect(world.stats).to.include({ bodies: 1, joints: 1 });
    expect(document.querySelectorAll('canvas').length).to.equal(1);
  });
});
