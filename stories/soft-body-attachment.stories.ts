import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  index: number;
  position: string;
  mass: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/SoftBodyAttachment',
  tags: ['autodocs'],
  args: { index: 10, position: '0 0.3 0', mass: 2 },
  argTypes: {
    index: { ...range(1, 19, 1), description: 'The point of the rope that the crate hangs from' },
    position: { description: 'Where on the crate, metres, in its frame: try "0.3 0.3 0"' },
    mass: { ...range(0.2, 10, 0.2), description: 'kg, of the crate' },
  },
  render: ({ index, position, mass }) =>
    scene(
      'A rope is tied to two posts by attachments without a body, and a crate to a point between: it pulls at the rope, and the rope at it.',
      html`
        ${ground}
        <transform translation="-2.5 1.5 0">
          ${shape('iron', html`<cylinder radius="0.1" height="3"></cylinder>`)}
        </transform>
        <transform translation="2.5 1.5 0">
          ${shape('iron', html`<cylinder radius="0.1" height="3"></cylinder>`)}
        </transform>
        <transform translation="0 2.2 0">
          ${shape('red', html`<box size="0.6 0.6 0.6"></box>`)}
          <x3d-rigid-body id="crate" mass=${mass} linearVelocity="0 0 1.5"></x3d-rigid-body>
        </transform>
        <x3d-rope
          id="line"
          points="-2.5 3 0  0 2.5 0  2.5 3 0"
          segments="20"
          mass="0.5"
          radius="0.04"
          damping="0.3"
        >
          ${shape('brass', html``)}
          <x3d-soft-body-attachment index="0" position="-2.5 3 0"></x3d-soft-body-attachment>
          <x3d-soft-body-attachment index="20" position="2.5 3 0"></x3d-soft-body-attachment>
        </x3d-rope>
        <x3d-soft-body-attachment
          soft-body="line"
          body="crate"
          index=${index}
          position=${position}
        ></x3d-soft-body-attachment>
      `,
    ),
};
export default meta;

export const SoftBodyAttachment: StoryObj<Args> = {};
