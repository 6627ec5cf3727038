import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import source from './code/show-motor.ts?raw';
import { showMotor } from './code/show-motor.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  autoCalc: boolean;
  enabledAxes: number;
  axis1Torque: number;
  axis2Torque: number;
}

const torque = { control: { type: 'range', min: -5, max: 5, step: 0.1 } } as const;

const meta: Meta<Args> = {
  title: 'Nodes/MotorJoint',
  tags: ['autodocs'],
  parameters: { code: source },
  args: { autoCalc: true, enabledAxes: 1, axis1Torque: 2, axis2Torque: 0 },
  argTypes: {
    autoCalc: { description: 'The angles are measured, as Euler angles' },
    enabledAxes: { control: { type: 'range', min: 0, max: 3, step: 1 } },
    axis1Torque: torque,
    axis2Torque: torque,
  },
  render: ({ autoCalc, enabledAxes, axis1Torque, axis2Torque }) =>
    scene(
      'The ball joint holds the propeller, the motor turns it: by axis 1 about Z, by axis 2 about Y.',
      html`
        <x3d-rigid-body-collection default @afterstep=${showMotor}></x3d-rigid-body-collection>
        ${ground}
        <transform translation="0 2 0">
          ${shape('red', html`<box size="3 0.3 0.1"></box>`)}
          ${shape('red', html`<box size="0.3 3 0.1"></box>`)}
          <x3d-rigid-body
            id="propeller"
            useGlobalGravity="false"
            autoDamp="true"
            angularDampingFactor="0.5"
          ></x3d-rigid-body>
        </transform>
        <x3d-ball-joint body1="propeller" anchorPoint="0 2 0"></x3d-ball-joint>
        <x3d-motor-joint
          body1="propeller"
          motor1Axis="0 0 1"
          motor2Axis="0 1 0"
          motor3Axis="0 1 0"
          forceOutput="ALL"
          autoCalc=${autoCalc}
          enabledAxes=${enabledAxes}
          axis1Torque=${axis1Torque}
          axis2Torque=${axis2Torque}
        ></x3d-motor-joint>
      `,
      { after: html`<p><output aria-live="off"></output></p>` },
    ),
};
export default meta;

export const MotorJoint: StoryObj<Args> = {};
