import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { fading, range, spots } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  speed: number;
  variation: number;
  mass: number;
  rise: number;
}

const paddles = [0, 1, 2].map(
  (i) =>
    html`<transform rotation="0 0 1 ${((i * Math.PI) / 3).toFixed(3)}">
      ${shape(i % 2 ? 'brass' : 'red', html`<box size="2.6 0.12 1"></box>`)}
    </transform>`,
);

const post = (z: number) =>
  html`<transform translation="1.3 0.75 ${z}">
    ${shape('iron', html`<box size="0.2 1.5 0.1"></box>`)}
    <x3d-rigid-body fixed></x3d-rigid-body>
  </transform>`;

const meta: Meta<Args> = {
  title: 'Nodes/PointEmitter',
  tags: ['autodocs'],
  args: { speed: 4, variation: 0.05, mass: 0.03, rise: 0.3 },
  argTypes: {
    speed: range(0, 8, 0.1),
    variation: range(0, 1, 0.05),
    mass: range(0.005, 0.1, 0.005),
    rise: {
      ...range(-1, 1, 0.05),
      description: 'How far the direction points upwards: it is 1 rise 0',
    },
  },
  render: ({ speed, variation, mass, rise }) =>
    scene(
      'From one point, all one way: a jet of water falls on a wheel, and its drops turn it.',
      html`
        ${ground}
        <transform translation="1.3 1.5 0">
          ${paddles} ${shape('iron', html`<box size="0.2 0.2 1.4"></box>`)}
          <x3d-rigid-body
            id="wheel"
            mass="3"
            autoDamp="true"
            angularDampingFactor="0.3"
          ></x3d-rigid-body>
        </transform>
        <x3d-single-axis-hinge-joint
          body1="wheel"
          axis="0 0 1"
          anchorPoint="1.3 1.5 0"
        ></x3d-single-axis-hinge-joint>
        ${post(-0.75)}${post(0.75)}
        <x3d-particle-system
          geometryType="SPRITE"
          maxParticles="600"
          particleLifetime="3"
          particleSize="0.14 0.14"
          collides="true"
          pushes="true"
          bounce="0.1"
          friction="0"
          colorKey="0 2 3"
        >
          ${spots}${fading('0.02 0.25 0.6 1', '0.1 0.45 0.8 1', '0.8 0.9 1 0')}
          <x3d-point-emitter
            position="-2 3 0"
            direction="1 ${rise} 0"
            speed=${speed}
            variation=${variation}
            mass=${mass}
          ></x3d-point-emitter>
          <x3d-force-physics-model
            force="0 ${(-9.8 * mass).toFixed(4)} 0"
          ></x3d-force-physics-model>
        </x3d-particle-system>
      `,
    ),
};
export default meta;

export const PointEmitter: StoryObj<Args> = {};
