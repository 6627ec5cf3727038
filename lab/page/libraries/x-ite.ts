import type { Hinge, PageScene, Thing } from '../scene.js';
import { HOOKS, isDrawn, SIZE, STYLE, text, type Library } from './library.js';

const geometry = ({ shape }: Thing): string =>
  typeof shape === 'number' ? `<Sphere radius="${shape}"/>` : `<Box size="${text(shape)}"/>`;

/** It has no motor of joints: the torque stands in the body, which comes to the same. */
function bodyOf(thing: Thing): string {
  const { name, mass, position, turn = 0, color, motor, damping } = thing;
  const fixed = isDrawn(thing) ? `mass="${mass}"` : 'fixed="true"';
  const torque = motor ? ` torques="0 ${motor} 0"` : '';
  const damped = damping
    ? ` autoDamp="true" linearDampingFactor="0" angularDampingFactor="${damping}"`
    : '';
  return `<RigidBody DEF="${name}" containerField="bodies" ${fixed} position="${text(position)}" orientation="0 1 0 ${turn}"${torque}${damped}>
    <CollidableShape DEF="${name}-shape" containerField="geometry"><Shape containerField="shape"><Appearance><Material diffuseColor="${text(color)}"/></Appearance>${geometry(thing)}</Shape></CollidableShape>
  </RigidBody>`;
}

const hinge = ({ bodies: [one, other], anchor }: Hinge): string =>
  `<SingleAxisHingeJoint containerField="joints" axis="0 1 0" anchorPoint="${text(anchor)}"><RigidBody USE="${one.name}" containerField="body1"/><RigidBody USE="${other.name}" containerField="body2"/></SingleAxisHingeJoint>`;

const file = ({ things, hinges, eye, down }: PageScene): string =>
  [
    '<X3D profile="Interchange" version="4.0"><head><component name="RigidBodyPhysics" level="5"/></head><Scene>',
    `<Viewpoint position="${text(eye)}" orientation="1 0 0 ${down ? -Math.PI / 2 : 0}"/>`,
    '<RigidBodyCollection DEF="world">',
    ...things.map(bodyOf),
    ...hinges.map(hinge),
    '</RigidBodyCollection>',
    ...things.filter(isDrawn).map(({ name }) => `<CollidableShape USE="${name}-shape"/>`),
    '</Scene></X3D>',
  ].join('\n');

export const xIte: Library = {
  id: 'x-ite',
  name: 'X_ITE',
  says: 'X_ITE 15.0.1 as it comes: ten steps of a tenth of the frame',
  type: 'text/html; charset=utf-8',
  page: (_, address) =>
    `<!DOCTYPE html><meta charset="utf-8">${HOOKS('x-ite')}${STYLE}<script src="/node_modules/x_ite/dist/x_ite.min.js"></script><body><x3d-canvas src="${address.replace('/page?', '/file?')}" style="width: ${SIZE.width}px; height: ${SIZE.height}px"></x3d-canvas></body>`,
  file,
};
