import { configure, explain, worldOf, X3DRigidBodyElement, type World } from 'x3d-physics';
import { createWorld } from 'x3d-physics/core';
import { X3DBallJointElement } from 'x3d-physics/elements/x3d-ball-joint';
import type { PhysicsElements } from 'x3d-physics/jsx';

configure({ wasmUrl: new URL('https://example.org/ammo.wasm'), workerUrl: '/worker.js' });
// @ts-expect-error There is no such file.
configure({ wsamUrl: '/ammo.wasm' });

export const world: World | undefined = worldOf(document.querySelector('x3d-rigid-body'));
export const fields: unknown = explain(new X3DRigidBodyElement());
export const joint: Element = new X3DBallJointElement();
export const made: Promise<World> = createWorld({ gravity: [0, -9.8, 0], wasmUrl: '/ammo.wasm' });
export const body: PhysicsElements['x3d-rigid-body'] = { mass: 2 };
