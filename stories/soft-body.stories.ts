import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  mass: number;
  youngsModulus: number;
  poissonsRatio: number;
  pressure: number;
  damping: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/SoftBody',
  tags: ['autodocs'],
  args: { mass: 4, youngsModulus: 20000, poissonsRatio: 0.3, pressure: 4000, damping: 0.5 },
  argTypes: {
    mass: { ...range(0.5, 20, 0.5), description: 'kg, of the block of jelly' },
    youngsModulus: { ...range(2000, 100000, 2000), description: 'Pa: how stiff the block is' },
    poissonsRatio: range(0, 0.45, 0.05),
    pressure: { ...range(500, 20000, 500), description: 'Pa above that of the air, of the ball' },
    damping: range(0, 4, 0.1),
  },
  render: ({ mass, youngsModulus, poissonsRatio, pressure, damping }) =>
    scene(
      'A block of jelly and a ball full of air fall onto the ground, and a crate onto the block. What they are laid as are the Shapes beside them, which are drawn where they go.',
      html`
        ${ground}
        <transform translation="-1.2 1.4 0" rotation="0 0 1 0.3">
          ${shape('brass', html`<box size="1.2 1.2 1.2"></box>`)}
          <x3d-soft-body
            mass=${mass}
            youngsModulus=${youngsModulus}
            poissonsRatio=${poissonsRatio}
            damping=${damping}
          ></x3d-soft-body>
        </transform>
        <transform translation="-1.2 3.4 0">
          ${shape('iron', html`<box size="0.5 0.5 0.5"></box>`)}
          <x3d-rigid-body mass="2"></x3d-rigid-body>
        </transform>
        <transform translation="1.2 2 0">
          ${shape('red', html`<sphere radius="0.6"></sphere>`)}
          <x3d-soft-body mass="0.5" pressure=${pressure} damping=${damping}></x3d-soft-body>
        </transform>
      `,
    ),
};
export default meta;

export const SoftBody: StoryObj<Args> = {};
