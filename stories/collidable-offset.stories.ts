import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  translation: string;
  rotation: string;
  enabled: boolean;
}

const meta: Meta<Args> = {
  title: 'Nodes/CollidableOffset',
  tags: ['autodocs'],
  args: { translation: '0 0.9 0', rotation: '0 0 1 0', enabled: true },
  argTypes: {
    translation: { description: 'Where the head sits on its handle, metres' },
    rotation: { description: 'Axis and angle: try "0 1 0 0.8"' },
  },
  render: ({ translation, rotation, enabled }) =>
    scene(
      'A hammer of two collidables: the offset places its head on the handle. What is drawn is what collides.',
      html`
        ${ground}
        <x3d-rigid-body
          mass="1"
          position="-1.5 3.5 0"
          angularVelocity="0 0 -5"
          linearVelocity="1.5 1 0"
        >
          <x3d-collidable-shape use="handle"></x3d-collidable-shape>
          <x3d-collidable-offset use="head"></x3d-collidable-offset>
        </x3d-rigid-body>
        <x3d-collidable-shape def="handle">
          ${shape('brass', html`<cylinder radius="0.08" height="2"></cylinder>`)}
        </x3d-collidable-shape>
        <x3d-collidable-offset
          def="head"
          translation=${translation}
          rotation=${rotation}
          enabled=${enabled}
        >
          <x3d-collidable-shape>
            ${shape('iron', html`<box size="0.9 0.4 0.4"></box>`)}
          </x3d-collidable-shape>
        </x3d-collidable-offset>
      `,
    ),
};
export default meta;

export const CollidableOffset: StoryObj<Args> = {};
