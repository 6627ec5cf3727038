import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { fading, glass, range, spots } from './particles.js';
import { ground, scene } from './scene.js';

interface Args {
  internal: boolean;
  speed: number;
  maxParticles: number;
  particleLifetime: number;
}

const CORNERS = '-1 -1 -1, 1 -1 -1, 1 1 -1, -1 1 -1, -1 -1 1, 1 -1 1, 1 1 1, -1 1 1';
const FACES = '0 3 2 1 -1 4 5 6 7 -1 0 1 5 4 -1 3 7 6 2 -1 0 4 7 3 -1 1 2 6 5 -1';

const meta: Meta<Args> = {
  title: 'Nodes/VolumeEmitter',
  tags: ['autodocs'],
  args: { internal: true, speed: 0.3, maxParticles: 700, particleLifetime: 1.5 },
  argTypes: {
    speed: range(0, 2, 0.05),
    maxParticles: range(0, 3000, 50),
    particleLifetime: range(0.2, 5, 0.1),
  },
  render: ({ internal, speed, maxParticles, particleLifetime }) =>
    scene(
      'Particles are born anywhere in a cube, whose faces close it; with internal FALSE only on its faces. They rise a little, and fade.',
      html`
        ${ground}
        <transform translation="0 1.8 0" rotation="0 1 0 0.5">
          ${glass('2 2 2')}
          <x3d-particle-system
            geometryType="SPRITE"
            maxParticles=${maxParticles}
            particleLifetime=${particleLifetime}
            particleSize="0.14 0.14"
            colorKey="0 0.5 1.5"
          >
            ${spots}${fading('0.8 0.06 0.04 1', '0.9 0.42 0.05 1', '0.9 0.6 0.1 0')}
            <x3d-volume-emitter internal=${internal} speed=${speed} coordIndex=${FACES}>
              <coordinate point=${CORNERS}></coordinate>
            </x3d-volume-emitter>
          </x3d-particle-system>
        </transform>
      `,
    ),
};
export default meta;

export const VolumeEmitter: StoryObj<Args> = {};
