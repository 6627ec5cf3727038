import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { fading, range, spots } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  speed: number;
  variation: number;
  on: boolean;
  maxParticles: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/SurfaceEmitter',
  tags: ['autodocs'],
  args: { speed: 0.6, variation: 0.5, on: true, maxParticles: 900 },
  argTypes: {
    speed: range(0, 4, 0.1),
    variation: range(0, 1, 0.05),
    maxParticles: range(0, 3000, 50),
  },
  render: ({ speed, variation, on, maxParticles }) =>
    scene(
      'Sparks leave the surface of a ball on a rope, straight away from it. The system stands in the Transform of the ball: so the ball carries it, and sparks go on as fast as the ball was.',
      html`
        ${ground}
        <transform translation="-2 2.6 0">
          ${shape('iron', html`<sphere radius="0.4"></sphere>`)}
          <x3d-rigid-body id="ball" mass="5"></x3d-rigid-body>
          <x3d-particle-system
            geometryType="SPRITE"
            maxParticles=${maxParticles}
            particleLifetime="1.5"
            particleSize="0.12 0.12"
            collides="true"
            bounce="0.4"
            colorKey="0 0.4 1 1.5"
          >
            ${spots} ${fading('1 0.6 0.05 1', '1 0.25 0 1', '0.5 0.04 0.02 0.8', '0.3 0.1 0.1 0')}
            <x3d-surface-emitter speed=${speed} variation=${variation} mass="1" on=${on}>
              <sphere radius="0.42"></sphere>
            </x3d-surface-emitter>
            <x3d-force-physics-model force="0 -2 0"></x3d-force-physics-model>
          </x3d-particle-system>
        </transform>
        <x3d-ball-joint body1="ball" anchorPoint="0 4 0"></x3d-ball-joint>
      `,
    ),
};
export default meta;

export const SurfaceEmitter: StoryObj<Args> = {};
