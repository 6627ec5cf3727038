import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  sliderForce: number;
  minSeparation: number;
  maxSeparation: number;
  stopBounce: number;
}

const meters = { control: { type: 'range', min: 0, max: 2.5, step: 0.05 } } as const;

const meta: Meta<Args> = {
  title: 'Nodes/SliderJoint',
  tags: ['autodocs'],
  args: { sliderForce: 70, minSeparation: 0, maxSeparation: 1.2, stopBounce: 0.3 },
  argTypes: {
    sliderForce: {
      control: { type: 'range', min: -50, max: 150, step: 5 },
      description: 'Newtons: below 30 the piston sinks under its own weight and that of the crate',
    },
    minSeparation: meters,
    maxSeparation: meters,
    stopBounce: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
  },
  render: ({ sliderForce, minSeparation, maxSeparation, stopBounce }) =>
    scene(
      'A piston slides up and down only. The slider force drives it to its upper stop, and throws what lies on it.',
      html`
        ${ground}
        ${[-0.75, 0.75].map(
          (x) =>
            html`<transform translation="${x} 1.3 0">
              ${shape('iron', html`<box size="0.2 2.6 1.4"></box>`)}
              <x3d-rigid-body fixed></x3d-rigid-body>
            </transform>`,
        )}
        <transform translation="0 1.1 0">
          ${shape('brass', html`<box size="1.1 0.3 1.1"></box>`)}
          <transform translation="0 -0.6 0">
            ${shape('iron', html`<cylinder radius="0.12" height="0.9"></cylinder>`)}
          </transform>
          <x3d-rigid-body id="piston" mass="2"></x3d-rigid-body>
        </transform>
        <x3d-slider-joint
          body1="piston"
          axis="0 1 0"
          sliderForce=${sliderForce}
          minSeparation=${minSeparation}
          maxSeparation=${maxSeparation}
          stopBounce=${stopBounce}
        ></x3d-slider-joint>
        <transform translation="0 1.55 0">
          ${shape('red', html`<box size="0.6 0.6 0.6"></box>`)}
          <x3d-rigid-body></x3d-rigid-body>
        </transform>
      `,
    ),
};
export default meta;

export const SliderJoint: StoryObj<Args> = {};
