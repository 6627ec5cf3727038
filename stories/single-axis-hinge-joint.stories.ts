import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  axis: string;
  minAngle: number;
  maxAngle: number;
  stopBounce: number;
}

const angle = { control: { type: 'range', min: -3.14, max: 3.14, step: 0.01 } } as const;

const meta: Meta<Args> = {
  title: 'Nodes/SingleAxisHingeJoint',
  tags: ['autodocs'],
  args: { axis: '0 1 0', minAngle: -1.5, maxAngle: 1.5, stopBounce: 0.6 },
  argTypes: {
    axis: { description: 'Try "1 0 0": the door becomes a flap' },
    minAngle: angle,
    maxAngle: angle,
    stopBounce: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
  },
  render: ({ axis, minAngle, maxAngle, stopBounce }) =>
    scene(
      'A ball strikes a door. The door turns between its stops, and bounces off them.',
      html`
        ${ground}
        <transform translation="-0.9 1.5 0">
          ${shape('iron', html`<cylinder radius="0.1" height="3"></cylinder>`)}
          <x3d-rigid-body id="post" fixed></x3d-rigid-body>
        </transform>
        <transform translation="0.25 1.5 0">
          ${shape('brass', html`<box size="2 2.6 0.12"></box>`)}
          <x3d-rigid-body id="door" mass="3"></x3d-rigid-body>
        </transform>
        <x3d-single-axis-hinge-joint
          body1="post"
          body2="door"
          anchorPoint="-0.9 1.5 0"
          axis=${axis}
          minAngle=${minAngle}
          maxAngle=${maxAngle}
          stopBounce=${stopBounce}
        ></x3d-single-axis-hinge-joint>
        <transform translation="0.9 1 4">
          ${shape('red', html`<sphere radius="0.35"></sphere>`)}
          <x3d-rigid-body mass="2" linearVelocity="0 2.5 -7"></x3d-rigid-body>
        </transform>
      `,
    ),
};
export default meta;

export const SingleAxisHingeJoint: StoryObj<Args> = {};
