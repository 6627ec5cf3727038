import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  cells: number;
  mass: number;
  thickness: number;
  bendStiffness: number;
  friction: number;
  wind: number;
}

/** Along its left edge, from the lower corner to the upper one: it has 21 points in each row, and 15 rows. */
const POLE = Array.from({ length: 15 }, (_, row) => 21 * row).join(' ');

const meta: Meta<Args> = {
  title: 'Nodes/Cloth',
  tags: ['autodocs'],
  args: { cells: 24, mass: 0.5, thickness: 0.04, bendStiffness: 0, friction: 0.5, wind: 5 },
  argTypes: {
    cells: { ...range(8, 32, 4), description: 'Along each side of the table cloth' },
    mass: { ...range(0.1, 4, 0.1), description: 'kg, of the table cloth' },
    thickness: { ...range(0.01, 0.1, 0.01), description: 'Metres' },
    bendStiffness: { ...range(0, 0.05, 0.001), description: 'N m: what it takes to bend it' },
    friction: range(0, 2, 0.05),
    wind: { ...range(0, 12, 0.5), description: 'm/s: how fast the air goes that moves the flag' },
  },
  render: ({ cells, mass, thickness, bendStiffness, friction, wind }) =>
    scene(
      'A cloth falls over a ball, and a flag blows in the wind. The cloth is laid as the Plane beside it, in the Transform of both; the flag says its size by itself, and is fixed along its pole.',
      html`
        ${ground}
        <transform translation="-1 0.9 0">
          ${shape('iron', html`<sphere radius="0.9"></sphere>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <transform translation="-1 2.4 0" rotation="1 0 0 -1.5708">
          ${shape('red', html`<plane size="2.6 2.6" subdivision=${`${cells} ${cells}`}></plane>`)}
          <x3d-cloth
            mass=${mass}
            thickness=${thickness}
            bendStiffness=${bendStiffness}
            friction=${friction}
          ></x3d-cloth>
        </transform>
        <transform translation="1.5 1.6 0">
          ${shape('iron', html`<cylinder radius="0.04" height="3.2"></cylinder>`)}
        </transform>
        <transform translation="2.4 2.5 0">
          <x3d-cloth
            size="1.8 1.2"
            subdivision="20 14"
            mass="0.2"
            fixedIndex=${POLE}
            wind="${wind} 0 ${0.2 * wind}"
          >
            ${shape('blue', html``)}
          </x3d-cloth>
        </transform>
      `,
    ),
};
export default meta;

export const Cloth: StoryObj<Args> = {};
