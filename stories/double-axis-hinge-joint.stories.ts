import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { restartFallen } from './code/restart-fallen.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  steering: number;
  desiredAngularVelocity2: number;
  maxTorque2: number;
  suspensionForce: number;
  suspensionErrorCorrection: number;
}

/** Metres: where the wheels are, from the middle of the car; and where that starts, on its circle. */
const WHEELS = [
  { id: 'front-left', x: 0.75, z: -0.65 },
  { id: 'front-right', x: 0.75, z: 0.65 },
  { id: 'rear-left', x: -0.75, z: -0.65 },
  { id: 'rear-right', x: -0.75, z: 0.65 },
];
const START = { x: 0, y: 0.42, z: -2.9 };

const place = (x: number, y: number, z: number) => `${START.x + x} ${START.y + y} ${START.z + z}`;

const wheel = ({ id, x, z }: (typeof WHEELS)[number]) => html`
  <transform translation=${place(x, 0, z)} rotation="1 0 0 1.5708">
    ${shape('iron', html`<cylinder radius="0.4" height="0.25"></cylinder>`)}
    ${shape('brass', html`<box size="0.6 0.27 0.1"></box>`)}
    <x3d-rigid-body id=${id} mass="0.8"></x3d-rigid-body>
  </transform>
`;

/** Half a cylinder across the way. */
const bump = (x: number, z: number, turned: number) => html`
  <transform translation="${x} -0.2 ${z}" rotation="0 1 0 ${turned}">
    <transform rotation="1 0 0 1.5708">
      ${shape('blue', html`<cylinder radius="0.32" height="2.6"></cylinder>`)}
      <x3d-rigid-body fixed></x3d-rigid-body>
    </transform>
  </transform>
`;

const meta: Meta<Args> = {
  title: 'Nodes/DoubleAxisHingeJoint',
  tags: ['autodocs'],
  args: {
    steering: 0.5,
    desiredAngularVelocity2: 7,
    maxTorque2: 4,
    suspensionForce: 0.05,
    suspensionErrorCorrection: 0.3,
  },
  argTypes: {
    steering: {
      control: { type: 'range', min: -0.6, max: 0.6, step: 0.05 },
      description: 'minAngle1 and maxAngle1 of the front wheels, radians: above 0 to the right',
    },
    desiredAngularVelocity2: { control: { type: 'range', min: -15, max: 15, step: 0.5 } },
    maxTorque2: { control: { type: 'range', min: 0, max: 10, step: 0.5 } },
    suspensionForce: {
      control: { type: 'range', min: 0, max: 0.2, step: 0.01 },
      description: 'Softness: 0 is rigid',
    },
    suspensionErrorCorrection: { control: { type: 'range', min: 0.1, max: 1, step: 0.05 } },
  },
  render: (args) =>
    scene(
      'A car of five bodies. Each wheel turns about axis 2, springs along axis 1, and the front ones steer about it.',
      html`
        <x3d-collision-collection
          collidables="*"
          appliedParameters='"FRICTION_COEFFICIENT-2"'
          frictionCoefficients="1 1"
        ></x3d-collision-collection>
        <x3d-rigid-body-collection default @afterstep=${restartFallen}></x3d-rigid-body-collection>
        ${ground} ${bump(2.9, 0, 1.5708)} ${bump(0, 2.9, 0)} ${bump(-2.9, 0, 1.5708)}
        <transform translation=${place(0, 0.2, 0)}>
          ${shape('red', html`<box size="2.4 0.25 0.9"></box>`)}
          <transform translation="-0.2 0.3 0">
            ${shape('red', html`<box size="1.1 0.4 0.8"></box>`)}
          </transform>
          <x3d-rigid-body id="car" mass="8"></x3d-rigid-body>
        </transform>
        ${WHEELS.map(wheel)}
        ${WHEELS.map(({ id, x, z }) => {
          const angle = x > 0 ? args.steering : 0;
          return html`<x3d-double-axis-hinge-joint
            body1="car"
            body2=${id}
            anchorPoint=${place(x, 0, z)}
            axis1="0 1 0"
            axis2="0 0 1"
            minAngle1=${angle}
            maxAngle1=${angle}
            desiredAngularVelocity2=${args.desiredAngularVelocity2}
            maxTorque2=${args.maxTorque2}
            suspensionForce=${args.suspensionForce}
            suspensionErrorCorrection=${args.suspensionErrorCorrection}
          ></x3d-double-axis-hinge-joint>`;
        })}
      `,
      { view: 'above' },
    ),
};
export default meta;

export const DoubleAxisHingeJoint: StoryObj<Args> = {};
