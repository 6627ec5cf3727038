import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html, nothing } from 'lit';
import { fading, plainLook, range, spots } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  maxParticles: number;
  particleLifetime: number;
  particleSize: number;
  collides: boolean;
  pushes: boolean;
  bounce: number;
  friction: number;
}

const crate = (color: 'red' | 'brass' | 'iron', x: number, z: number) => html`
  <transform translation="${x} 1 ${z}">
    ${shape(color, html`<box size="0.8 0.8 0.8"></box>`)}
    <x3d-rigid-body></x3d-rigid-body>
  </transform>
`;

const meta: Meta<Args> = {
  title: 'Nodes/ParticleSystem',
  tags: ['autodocs'],
  args: {
    maxParticles: 800,
    particleLifetime: 2.2,
    particleSize: 0.12,
    collides: true,
    pushes: true,
    bounce: 0.3,
    friction: 0.1,
  },
  argTypes: {
    maxParticles: range(0, 3000, 50),
    particleLifetime: range(0.2, 5, 0.1),
    particleSize: range(0.02, 0.5, 0.01),
    bounce: range(0, 1, 0.05),
    friction: range(0, 1, 0.05),
  },
  render: ({ particleSize, ...args }) =>
    scene(
      'A fountain: drops fly up, fall on the crates and the ground, and bounce. Each weighs 20 g and pushes what it meets: the ball dances on them until it slips off.',
      html`
        ${ground} ${crate('red', -1.5, 0.6)}${crate('brass', 1.6, 0.2)}${crate('iron', -0.2, -1.6)}
        <transform translation="0 3.6 0">
          ${shape('red', html`<sphere radius="0.45"></sphere>`)}
          <x3d-rigid-body mass="0.6"></x3d-rigid-body>
        </transform>
        <transform translation="0 0.1 0">
          <x3d-particle-system
            geometryType="SPRITE"
            maxParticles=${args.maxParticles}
            particleLifetime=${args.particleLifetime}
            particleSize="${particleSize} ${particleSize}"
            collides=${args.collides}
            pushes=${args.pushes}
            bounce=${args.bounce}
            friction=${args.friction}
            colorKey="0 1.2 2.2"
          >
            ${spots}${fading('0.02 0.2 0.7 1', '0.2 0.5 0.9 0.9', '0.9 0.95 1 0')}
            <x3d-cone-emitter angle="0.25" speed="7" mass="0.02"></x3d-cone-emitter>
            <x3d-force-physics-model force="0 -0.196 0"></x3d-force-physics-model>
          </x3d-particle-system>
        </transform>
      `,
    ),
};
export default meta;

export const ParticleSystem: StoryObj<Args> = {};

interface Forms {
  width: number;
  height: number;
}

const jet = (type: string, i: number, { width, height }: Forms) => html`
  <x3d-particle-system
    geometryType=${type}
    maxParticles="40"
    particleLifetime="2"
    particleSize="${width} ${height}"
  >
    ${plainLook('0.03 0.3 0.42', /LINE|POINT/.test(type))}
    ${type === 'GEOMETRY' ? html`<box size="0.2 0.2 0.2"></box>` : nothing}
    <x3d-cone-emitter
      position="${1.3 * i - 3.25} 0.1 0"
      angle="0.12"
      speed="6"
      mass="1"
    ></x3d-cone-emitter>
    <x3d-force-physics-model></x3d-force-physics-model>
  </x3d-particle-system>
`;

const TYPES = ['QUAD', 'TRIANGLE', 'SPRITE', 'LINE', 'POINT', 'GEOMETRY'];

/** What particles are drawn as. */
export const GeometryTypes: StoryObj<Forms> = {
  args: { width: 0.2, height: 0.3 },
  argTypes: { width: range(0.02, 0.5, 0.01), height: range(0.02, 0.5, 0.01) },
  parameters: { controls: { include: ['width', 'height'] } },
  render: (args) =>
    scene(
      'From the left: QUAD, TRIANGLE, SPRITE, LINE, POINT and GEOMETRY, here a box. Turn the view: sprites follow it.',
      html`${ground}${TYPES.map((type, i) => jet(type, i, args))}`,
    ),
};
