import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  anchorPoint: string;
}

const meta: Meta<Args> = {
  title: 'Nodes/BallJoint',
  tags: ['autodocs'],
  args: { anchorPoint: '0 4 0' },
  argTypes: {
    anchorPoint: { description: 'The point that both bodies share, metres: try "1.2 4 0"' },
  },
  render: ({ anchorPoint }) =>
    scene(
      'A plate hangs from a point of the ball above and turns about it freely. Another anchor point is held from where the bodies are.',
      html`
        ${ground}
        <transform translation="0 4 0">
          ${shape('iron', html`<sphere radius="0.15"></sphere>`)}
          <x3d-rigid-body id="hook" fixed></x3d-rigid-body>
        </transform>
        <transform translation="1.2 4 0">
          ${shape('brass', html`<box size="2.2 0.15 1"></box>`)}
          <x3d-rigid-body id="plate" angularVelocity="2 1 0"></x3d-rigid-body>
        </transform>
        <x3d-ball-joint body1="hook" body2="plate" anchorPoint=${anchorPoint}></x3d-ball-joint>
      `,
    ),
};
export default meta;

export const BallJoint: StoryObj<Args> = {};
