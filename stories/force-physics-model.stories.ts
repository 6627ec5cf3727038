import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { plainLook, range } from './particles.js';
import { ground, scene } from './scene.js';

interface Args {
  enabled: boolean;
  aside: number;
  down: number;
}

interface Jet extends Args {
  z: number;
  mass: number;
  color: string;
}

const jet = ({ z, mass, color, enabled, aside, down }: Jet) => html`
  <x3d-particle-system
    geometryType="GEOMETRY"
    maxParticles="90"
    particleLifetime="3"
    lifetimeVariation="0"
    particleSize="0.16 0.16"
    collides="true"
    bounce="0.6"
    friction="0"
  >
    ${plainLook(color)}
    <sphere radius="0.08" subdivision="10 10"></sphere>
    <x3d-point-emitter
      position="-3 0.6 ${z}"
      direction="1 1.6 0"
      speed="5"
      variation="0"
      mass=${mass}
    ></x3d-point-emitter>
    <x3d-force-physics-model
      enabled=${enabled}
      force="${aside} ${-down} 0"
    ></x3d-force-physics-model>
  </x3d-particle-system>
`;

const meta: Meta<Args> = {
  title: 'Nodes/ForcePhysicsModel',
  tags: ['autodocs'],
  args: { enabled: true, aside: 0, down: 9.8 },
  argTypes: {
    aside: { ...range(-10, 10, 0.1), description: 'Newtons: the force is aside −down 0' },
    down: { ...range(-5, 20, 0.1), description: 'Newtons: the force is aside −down 0' },
  },
  render: (args) =>
    scene(
      'The same force on both: beads of 2 kg, the blue ones, leave their way half as fast as red ones of 1 kg.',
      html`
        ${ground} ${jet({ ...args, z: 0.6, mass: 1, color: '0.6 0.06 0.04' })}
        ${jet({ ...args, z: -0.6, mass: 2, color: '0.03 0.3 0.42' })}
      `,
    ),
};
export default meta;

export const ForcePhysicsModel: StoryObj<Args> = {};
