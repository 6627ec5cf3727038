import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { glass, plainLook, range } from './particles.js';
import { ground, scene } from './scene.js';

interface Args {
  enabled: boolean;
  width: number;
  speed: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/BoundedPhysicsModel',
  tags: ['autodocs'],
  args: { enabled: true, width: 4, speed: 2 },
  argTypes: {
    width: { ...range(2, 6, 0.1), description: 'Metres, of the box' },
    speed: range(0, 6, 0.1),
  },
  render: ({ enabled, width, speed }) =>
    scene(
      'A gas in a box: what meets a wall, from either side, comes back as fast as it came.',
      html`
        ${ground}
        <transform translation="0 1.7 0">
          ${glass(`${width} 2.6 2.6`)}
          <x3d-particle-system
            geometryType="GEOMETRY"
            maxParticles="150"
            particleLifetime="20"
            particleSize="0.14 0.14"
          >
            ${plainLook('0.75 0.42 0.1')}
            <sphere radius="0.07" subdivision="10 10"></sphere>
            <x3d-explosion-emitter speed=${speed} variation="0.8" mass="1"></x3d-explosion-emitter>
            <x3d-bounded-physics-model enabled=${enabled}>
              <box size="${width} 2.6 2.6"></box>
            </x3d-bounded-physics-model>
          </x3d-particle-system>
        </transform>
      `,
    ),
};
export default meta;

export const BoundedPhysicsModel: StoryObj<Args> = {};
