import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  speed: number;
  variation: number;
  slant: number;
  maxParticles: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/PolylineEmitter',
  tags: ['autodocs'],
  args: { speed: 3, variation: 0.25, slant: 0.1, maxParticles: 900 },
  argTypes: {
    speed: range(0, 8, 0.1),
    variation: range(0, 1, 0.05),
    slant: {
      ...range(-1, 1, 0.05),
      description: 'Where the rain drives: its direction is slant -1 0',
    },
    maxParticles: range(0, 3000, 50),
  },
  render: ({ speed, variation, slant, maxParticles }) =>
    scene(
      'Rain from a line that goes to and fro above the hut: drops are born anywhere on it, and run off the roof.',
      html`
        ${ground}
        <transform translation="0 0.7 0">
          ${shape('brass', html`<cylinder radius="1.1" height="1.4"></cylinder>`)}
          <transform translation="0 1.2 0">
            ${shape('red', html`<cone bottomRadius="1.7" height="1"></cone>`)}
          </transform>
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <x3d-particle-system
          geometryType="LINE"
          maxParticles=${maxParticles}
          particleLifetime="2"
          particleSize="0.02 0.2"
          collides="true"
          bounce="0.2"
          friction="0.05"
        >
          <appearance><material emissiveColor="0.03 0.2 0.6"></material></appearance>
          <x3d-polyline-emitter
            direction="${slant} -1 0"
            speed=${speed}
            variation=${variation}
            mass="1"
          >
            <coordinate
              point="-2.5 4.2 1, 2.5 4.2 0.5, -2.5 4.2 0, 2.5 4.2 -0.5, -2.5 4.2 -1"
            ></coordinate>
          </x3d-polyline-emitter>
          <x3d-force-physics-model></x3d-force-physics-model>
        </x3d-particle-system>
      `,
    ),
};
export default meta;

export const PolylineEmitter: StoryObj<Args> = {};
