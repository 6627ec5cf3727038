// One element module by itself knows its properties, its events and its tag.
import { X3DRigidBodyElement } from 'x3d-physics/elements/x3d-rigid-body.js';

export function one(body: X3DRigidBodyElement): number {
  body.mass = 3;
  body.mass = '3';
  body.position = new Float32Array([0, 5, 0]);
  body.position = '0 5 0';
  body.orientation = null;
  body.fixed = true;
  body.for = 'ball';
  const [, y]: number[] = body.position;
  const tag: X3DRigidBodyElement = document.createElement('x3d-rigid-body');
  tag.addEventListener('collisionstart', ({ detail }) => detail.impulse > 1);
  tag.addEventListener('click', ({ clientX }) => clientX);
  customElements.define(X3DRigidBodyElement.tag, X3DRigidBodyElement);
  // @ts-expect-error A mass is no list.
  body.mass = [3];
  // @ts-expect-error There is no such property.
  body.maas = 3;
  return y! + body.world!.timeStep;
}
