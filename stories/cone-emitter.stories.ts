import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { fading, range, spots } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  angle: number;
  lean: number;
  speed: number;
  variation: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/ConeEmitter',
  tags: ['autodocs'],
  args: { angle: 0.35, lean: 0, speed: 7, variation: 0.25 },
  argTypes: {
    angle: range(0, Math.PI, 0.05),
    lean: { ...range(-1, 1, 0.05), description: 'How far the direction leans: it is lean 1 0' },
    speed: range(0, 10, 0.5),
    variation: range(0, 1, 0.05),
  },
  render: ({ angle, lean, speed, variation }) =>
    scene(
      'A volcano: sparks leave one point within a cone, cool down, and come to rest on its slopes and around.',
      html`
        ${ground}
        <transform translation="0 0.5 0">
          ${shape('iron', html`<cone bottomRadius="1.6" topRadius="0.3" height="1"></cone>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <x3d-particle-system
          geometryType="SPRITE"
          maxParticles="900"
          particleLifetime="3"
          particleSize="0.13 0.13"
          collides="true"
          bounce="0.3"
          colorKey="0 0.6 1.6 3"
        >
          ${spots} ${fading('1 0.6 0.05 1', '1 0.25 0 1', '0.5 0.04 0.02 1', '0.15 0.1 0.1 0')}
          <x3d-cone-emitter
            position="0 1.1 0"
            direction="${lean} 1 0"
            angle=${angle}
            speed=${speed}
            variation=${variation}
            mass="1"
          ></x3d-cone-emitter>
          <x3d-force-physics-model></x3d-force-physics-model>
        </x3d-particle-system>
      `,
    ),
};
export default meta;

export const ConeEmitter: StoryObj<Args> = {};
