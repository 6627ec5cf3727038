import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  gravity: string;
  enabled: boolean;
  accuracy: string;
}

const LEVELS = ['game', 'standard', 'fine', 'precise', 'reference'];

/** A tower of planks, crosswise, and a ball that comes for it. */
const planks = Array.from({ length: 16 }, (_, i) => {
  const layer = i >> 1;
  const side = i % 2 ? 0.5 : -0.5;
  const size = layer % 2 ? '1.4 0.3 0.4' : '0.4 0.3 1.4';
  const at = layer % 2 ? `0 ${0.15 + 0.3 * layer} ${side}` : `${side} ${0.15 + 0.3 * layer} 0`;
  return html`<transform translation=${at}>
    ${shape(layer % 2 ? 'brass' : 'blue', html`<box size=${size}></box>`)}
    <x3d-rigid-body mass="0.5"></x3d-rigid-body>
  </transform>`;
});

const meta: Meta<Args> = {
  title: 'Nodes/RigidBodyCollection',
  tags: ['autodocs'],
  args: { gravity: '0 -9.8 0', enabled: true, accuracy: 'standard' },
  argTypes: {
    gravity: { control: 'text', description: 'm/s²: try "0 -1.6 0", the moon, or "3 -9.8 0"' },
    accuracy: { control: 'select', options: LEVELS },
  },
  render: ({ gravity, enabled, accuracy }) =>
    scene(
      'The collection gives its bodies gravity and accuracy. Marked as default, it speaks for all bodies outside any collection.',
      html`
        <x3d-rigid-body-collection
          default
          gravity=${gravity}
          enabled=${enabled}
          accuracy=${accuracy}
        ></x3d-rigid-body-collection>
        ${ground}${planks}
        <transform translation="-4 1.6 0">
          ${shape('red', html`<sphere radius="0.4"></sphere>`)}
          <x3d-rigid-body mass="3" linearVelocity="10 1 0"></x3d-rigid-body>
        </transform>
      `,
    ),
};
export default meta;

export const RigidBodyCollection: StoryObj<Args> = {};
