import { configure, explain, worldOf, X3DRigidBodyElement, type World } from 'x3d-physics';
import { createWorld, debugLines, type Body, type World as CoreWorld } from 'x3d-physics/core';
import { X3DBallJointElement } from 'x3d-physics/elements/x3d-ball-joint';
import type { PhysicsElements } from 'x3d-physics/jsx';

configure({ wasmUrl: new URL('https://example.org/ammo.wasm'), workerUrl: '/worker.js' });
// @ts-expect-error There is no such file.
configure({ wsamUrl: '/ammo.wasm' });

export const fields: unknown = explain(new X3DRigidBodyElement());
export const joint: Element = new X3DBallJointElement();
export const attributes: PhysicsElements['x3d-rigid-body'] = { mass: 2 };

/** The page, as the guide has it. */
export async function page(): Promise<void> {
  const body = document.querySelector('x3d-rigid-body')!;
  const world: World = worldOf(body)!;
  const same: World | undefined = body.world;
  await world.ready;
  world.paused = same!.paused;
  const seconds: number = world.step(10) + world.advance(0.5);
  const { bodies, ms } = world.stats;
  const hit = world.raycast([0, 10, 0], new Float32Array([0, -10, 0]));
  const at: [number, number, number] | undefined = hit?.position;
  const element: Element | undefined = hit?.element;
  const first: string | undefined = world.problems[0]?.message ?? world.effects[0]?.name;
  const before = world.snapshot();
  world.restore(before);
  world.accuracy = 'auto';
  const [level] = await world.measureAccuracy({ seconds: 2, levels: ['game', 'fine'] });
  const error: number = level!.error.position;
  const stop = world.recordCosts('console');
  const p99: number | undefined = world.costs?.total.p99;
  stop();
  const ball = world.node('ball')!;
  const where: [number, number, number] = ball.get('position');
  body.teleport([0, 5, 0], [0, 1, 0, 0], { linearVelocity: [0, 0, 0] });
  body.applyImpulse([0, 3, 0]);
  const drag = body.drag([0, 1, 0]);
  drag?.move([2, 1, 0]);
  drag?.end();
  // @ts-expect-error The engine is nobody's business.
  void world.bullet;
  // @ts-expect-error Nor what it works with.
  void world.registry;
  // @ts-expect-error There is no such field.
  ball.set('maas', 3);
  console.log(seconds, bodies, ms.step, at, element, first, error, p99, where);
}

/** Events bubble: they may be heard at the element and wherever else. */
export function events(): void {
  const body = document.querySelector('x3d-rigid-body')!;
  const hinge = document.createElement('x3d-single-axis-hinge-joint');
  body.addEventListener('collisionstart', ({ detail }) => detail.other.id);
  body.addEventListener('collisionend', ({ detail }) => detail.reason?.length);
  hinge.addEventListener('jointlimit', ({ detail }) => detail.limit === 'min');
  body.addEventListener('waterenter', ({ detail }) => detail.water.id && detail.depth > 0);
  document.querySelector('RigidBody')!.addEventListener('wake', ({ detail }) => detail.time);
  document.addEventListener('physicsproblem', ({ detail }) => detail.message.length);
  const told = ({ detail }: HTMLElementEventMap['bodydragstart']): string => detail.mode;
  document.body.addEventListener('bodydragstart', told, { once: true });
  document.body.removeEventListener('bodydragstart', told);
  // @ts-expect-error It has no such detail.
  body.addEventListener('sleep', ({ detail }) => detail.other);
}

/** The core, as the guide has it, with handles and events. */
export async function core(): Promise<void> {
  const world: CoreWorld = await createWorld({ gravity: [0, -9.8, 0], wasmUrl: '/ammo.wasm' });
  const ball: Body = world.add('RigidBody', {
    mass: 2,
    position: [0, 5, 0],
    geometry: [{ type: 'Sphere', radius: 0.5 }],
  });
  const shape = world.add('CollidableShape', { shape: { type: 'Box', size: [1, 1, 1] } });
  const box = world.add('RigidBody', { geometry: shape, dragMode: 'kinematic' }, { name: 'box' });
  const hinge = world.add('SingleAxisHingeJoint', { body1: ball, body2: box, axis: [0, 0, 1] });
  const all = world.add('CollisionCollection', { collidables: '*', appliedParameters: ['BOUNCE'] });
  const sensor = world.add('CollisionSensor', { collider: all });
  world.advance(1);
  const [, y]: [number, number, number] = ball.get('position');
  const angle: number = hinge.get('angle');
  ball.set('mass', 3);
  ball.unset('mass');
  const pose: Float64Array = ball.readPose(new Float64Array(7));
  const stop = ball.on('collisionstart', ({ other, contacts }) => [other.name, contacts[0]?.depth]);
  stop();
  ball.on('collisionend', ({ reason }) => reason === 'separated');
  ball.on('waterleave', ({ water, speed }) => water.get('density') > 0 && speed < 0);
  hinge.on('jointlimit', ({ limit, value }) => limit === 'max' && value > 0);
  sensor.on('isActive', (active) => active === true);
  world.on('beforestep', ({ timeStep }) => ball.applyForce([0, timeStep, 0]));
  world.on('accuracy', ({ level, because }) => `${level}: ${because}`);
  // @ts-expect-error There is no such event.
  ball.on('jointlimit', () => {});
  // @ts-expect-error There is no such type.
  world.add('RigidBdoy');
  // @ts-expect-error There is no such field.
  world.add('RigidBody', { maas: 2 });
  // @ts-expect-error A mass is a number.
  ball.set('mass', [3]);
  // @ts-expect-error Outputs can't be set.
  hinge.set('angle', 1);
  // @ts-expect-error The engine is nobody's business.
  void world.engine;
  (await debugLines(world)).update();
  world.destroy();
  console.log(y, angle, pose);
}
