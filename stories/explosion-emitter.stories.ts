import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { burst } from './code/burst.js';
import source from './code/burst.ts?raw';
import { fading, range, spots } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  speed: number;
  variation: number;
  mass: number;
  on: boolean;
}

const crate = (color: 'red' | 'brass' | 'blue', x: number, y: number, z: number) =>
  html`<transform translation="${x} ${y} ${z}">
    ${shape(color, html`<box size="0.7 0.7 0.7"></box>`)}
    <x3d-rigid-body></x3d-rigid-body>
  </transform>`;

const meta: Meta<Args> = {
  title: 'Nodes/ExplosionEmitter',
  tags: ['autodocs'],
  parameters: { code: source },
  args: { speed: 6, variation: 0.4, mass: 0.02, on: true },
  argTypes: {
    speed: range(0, 12, 0.5),
    variation: range(0, 1, 0.05),
    mass: range(0.005, 0.1, 0.005),
  },
  render: ({ speed, variation, mass, on }) =>
    scene(
      'All particles at once, each another way. They push the crates aside.',
      html`
        ${ground}
        ${crate('red', -1, 0.35, 0)}${crate('brass', 1, 0.35, 0.2)}${crate('blue', 0.1, 0.35, -1)}
        ${crate('brass', -0.9, 1.05, -0.1)}${crate('red', 0.9, 1.05, 0.1)}
        <x3d-particle-system
          geometryType="SPRITE"
          maxParticles="600"
          particleSize="0.14 0.14"
          collides="true"
          pushes="true"
          bounce="0.3"
          damping="0.3"
          colorKey="0 0.5 2 5"
        >
          ${spots} ${fading('1 0.7 0.1 1', '0.95 0.3 0.02 1', '0.5 0.05 0.02 0.9', '0.3 0.3 0.3 0')}
          <x3d-explosion-emitter
            position="0 0.8 0"
            speed=${speed}
            variation=${variation}
            mass=${mass}
            on=${on}
          ></x3d-explosion-emitter>
          <x3d-force-physics-model
            force="0 ${(-9.8 * mass).toFixed(4)} 0"
          ></x3d-force-physics-model>
        </x3d-particle-system>
      `,
      { buttons: html`<button type="button" @click=${burst}>Once more</button>` },
    ),
};
export default meta;

export const ExplosionEmitter: StoryObj<Args> = {};
