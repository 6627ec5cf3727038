import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { fading, puffs, range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  enabled: boolean;
  speed: number;
  gustiness: number;
  turbulence: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/WindPhysicsModel',
  tags: ['autodocs'],
  args: { enabled: true, speed: 1.5, gustiness: 0.6, turbulence: 0.4 },
  argTypes: {
    speed: range(0, 4, 0.1),
    gustiness: range(0, 1, 0.05),
    turbulence: range(0, 1, 0.05),
  },
  render: ({ enabled, speed, gustiness, turbulence }) =>
    scene(
      'Smoke rises from a chimney, and the wind takes it along: by the area that each puff shows to it.',
      html`
        ${ground}
        <transform translation="-2.2 0.6 0">
          ${shape('red', html`<cylinder radius="0.3" height="1.2"></cylinder>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <x3d-particle-system
          geometryType="SPRITE"
          maxParticles="300"
          particleLifetime="4"
          particleSize="0.35 0.35"
          damping="0.6"
          colorKey="0 1 4"
        >
          ${puffs}${fading('0.1 0.1 0.12 0.8', '0.17 0.19 0.22 0.5', '0.3 0.32 0.35 0')}
          <x3d-cone-emitter
            position="-2.2 1.2 0"
            angle="0.4"
            speed="1.2"
            mass="1"
            surfaceArea="0.7"
          ></x3d-cone-emitter>
          <x3d-force-physics-model force="0 0.5 0"></x3d-force-physics-model>
          <x3d-wind-physics-model
            enabled=${enabled}
            direction="1 0 0"
            speed=${speed}
            gustiness=${gustiness}
            turbulence=${turbulence}
          ></x3d-wind-physics-model>
        </x3d-particle-system>
      `,
    ),
};
export default meta;

export const WindPhysicsModel: StoryObj<Args> = {};
