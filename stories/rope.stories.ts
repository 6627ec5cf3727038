import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  segments: number;
  mass: number;
  radius: number;
  friction: number;
  load: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/Rope',
  tags: ['autodocs'],
  args: { segments: 32, mass: 1, radius: 0.05, friction: 0.5, load: 4 },
  argTypes: {
    segments: { ...range(4, 64, 1), description: 'Links of one length' },
    mass: { ...range(0.1, 10, 0.1), description: 'kg, of the whole rope' },
    radius: { ...range(0.02, 0.15, 0.01), description: 'Metres' },
    friction: range(0, 2, 0.05),
    load: { ...range(0.2, 20, 0.2), description: 'kg, of the red ball; the blue one has 2' },
  },
  render: ({ segments, mass, radius, friction, load }) =>
    scene(
      'A rope lies over a beam, with a ball at each of its ends: friction holds the heavier one, up to a point. The rope is laid along the LineSet of the Shape in it, and that Shape is drawn where it goes.',
      html`
        ${ground}
        <transform translation="0 3.5 0" rotation="1 0 0 1.5708">
          ${shape('iron', html`<cylinder radius="0.5" height="2"></cylinder>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <transform translation="-0.56 1.5 0">
          ${shape('blue', html`<sphere radius="0.3"></sphere>`)}
          <x3d-rigid-body id="left" mass="2"></x3d-rigid-body>
        </transform>
        <transform translation="0.56 1.5 0">
          ${shape('red', html`<sphere radius="0.3"></sphere>`)}
          <x3d-rigid-body id="right" mass=${load}></x3d-rigid-body>
        </transform>
        <x3d-rope segments=${segments} mass=${mass} radius=${radius} friction=${friction}>
          ${shape(
            'brass',
            html`<lineset vertexCount="9">
              <coordinate
                point="-0.56 1.8 0 -0.56 3.5 0 -0.48 3.78 0 -0.28 3.98 0 0 4.06 0 0.28 3.98 0 0.48 3.78 0 0.56 3.5 0 0.56 1.8 0"
              ></coordinate>
            </lineset>`,
          )}
          <x3d-soft-body-attachment
            index="0"
            body="left"
            position="0 0.3 0"
          ></x3d-soft-body-attachment>
          <x3d-soft-body-attachment
            index=${segments}
            body="right"
            position="0 0.3 0"
          ></x3d-soft-body-attachment>
        </x3d-rope>
      `,
      { view: 'high' },
    ),
};
export default meta;

export const Rope: StoryObj<Args> = {};
