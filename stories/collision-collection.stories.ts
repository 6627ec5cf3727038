import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { startOver } from './code/start-over.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  bounce: number;
  minBounceSpeed: number;
  friction: number;
  enabled: boolean;
}

const balls = [-2.4, -0.8, 0.8, 2.4].map(
  (x, i) =>
    html`<transform translation="${x} ${2 + 0.6 * i} 0.6">
      ${shape('red', html`<sphere radius="0.4"></sphere>`)}
      <x3d-rigid-body></x3d-rigid-body>
    </transform>`,
);

const range = (min: number, max: number, step: number) =>
  ({ control: { type: 'range', min, max, step } }) as const;

const meta: Meta<Args> = {
  title: 'Nodes/CollisionCollection',
  tags: ['autodocs'],
  args: { bounce: 0.8, minBounceSpeed: 0.1, friction: 0.3, enabled: true },
  argTypes: {
    bounce: range(0, 1, 0.05),
    minBounceSpeed: range(0, 5, 0.1),
    friction: range(0, 1, 0.05),
  },
  render: ({ bounce, minBounceSpeed, friction, enabled }) =>
    scene(
      'The balls bounce and the block slides as the collection says; it lists every collidable of its world.',
      html`
        <x3d-collision-collection
          collidables="*"
          appliedParameters='"BOUNCE" "FRICTION_COEFFICIENT-2"'
          bounce=${bounce}
          minBounceSpeed=${minBounceSpeed}
          frictionCoefficients="${friction} ${friction}"
          enabled=${enabled}
        ></x3d-collision-collection>
        ${ground}${balls}
        <transform translation="-4 0.25 -1">
          ${shape('blue', html`<box size="0.8 0.5 0.8"></box>`)}
          <x3d-rigid-body linearVelocity="5 0 0"></x3d-rigid-body>
        </transform>
      `,
    ),
};
export default meta;

export const CollisionCollection: StoryObj<Args> = {};

const use = (name: string) =>
  html`<x3d-collidable-shape use=${name} containerfield="collidables"></x3d-collidable-shape>`;

interface Surface {
  surfaceSpeed: number;
  friction: number;
}

const crates = [-4.4, -1.5, 1.4].map((x, i) => ({ name: `crate${i}`, at: `${x} 1.6 0` }));

/** A moving belt that carries crates off its end. */
export const SurfaceSpeed: StoryObj<Surface> = {
  args: { surfaceSpeed: 1.5, friction: 0.8 },
  argTypes: { surfaceSpeed: range(-3, 3, 0.1), friction: range(0, 1, 0.05) },
  parameters: { controls: { include: ['surfaceSpeed', 'friction'] } },
  render: ({ surfaceSpeed, friction }) =>
    scene(
      'A conveyor: the belt stands still, but its surface moves and carries the crates along by friction.',
      html`
        <x3d-rigid-body-collection default @afterstep=${startOver}></x3d-rigid-body-collection>
        <x3d-collision-collection
          appliedParameters='"SPEED-1" "FRICTION_COEFFICIENT-2"'
          surfaceSpeed="${surfaceSpeed} 0"
          frictionCoefficients="${friction} ${friction}"
        >
          ${use('belt')} ${crates.map(({ name }) => use(name))}
        </x3d-collision-collection>
        ${ground}
        <x3d-collidable-shape def="belt" translation="0 0.7 0">
          ${shape('iron', html`<box size="10 0.3 1.4"></box>`)}
        </x3d-collidable-shape>
        ${crates.map(
          ({ name, at }, i) =>
            html`<x3d-rigid-body class="returns" position=${at}>
                <x3d-collidable-shape use=${name}></x3d-collidable-shape>
              </x3d-rigid-body>
              <x3d-collidable-shape def=${name}>
                ${shape(i % 2 ? 'blue' : 'brass', html`<box size="0.8 0.8 0.8"></box>`)}
              </x3d-collidable-shape>`,
        )}
      `,
    ),
};

interface Slip {
  slipFactor: number;
}

/** One block on each half of a slope. */
const block = (name: string, color: 'red' | 'blue', z: number) => html`
  <x3d-rigid-body position="-2.59 3.13 ${z}" orientation="0 0 1 -0.35">
    <x3d-collidable-shape use=${name}></x3d-collidable-shape>
  </x3d-rigid-body>
  <x3d-collidable-shape def=${name}>
    ${shape(color, html`<box size="0.9 0.5 0.9"></box>`)}
  </x3d-collidable-shape>
`;

/** Friction that gives way in proportion to the force. */
export const SlipFactors: StoryObj<Slip> = {
  args: { slipFactor: 0.15 },
  argTypes: {
    slipFactor: {
      ...range(0, 1, 0.01),
      description: 'Speed per force, (m/s)/N: the slope pulls with 3.4 N',
    },
  },
  parameters: { controls: { include: ['slipFactor'] } },
  render: ({ slipFactor }) =>
    scene(
      'Both blocks have friction enough to stick to the slope. The red one slips: it creeps down at a speed in proportion to the pull.',
      html`
        <x3d-collision-collection
          appliedParameters='"FRICTION_COEFFICIENT-2" "SLIP-1" "SLIP-2"'
          frictionCoefficients="1 1"
          slipFactors="${slipFactor} ${slipFactor}"
        >
          ${use('slipping')} ${use('slope')}
        </x3d-collision-collection>
        ${ground}
        <x3d-collidable-shape def="slope" translation="0 1.75 0" rotation="0 0 1 -0.35">
          ${shape('iron', html`<box size="8 0.3 3"></box>`)}
        </x3d-collidable-shape>
        ${block('slipping', 'red', 0.75)} ${block('sticking', 'blue', -0.75)}
      `,
    ),
};

interface Softness {
  softnessConstantForceMix: number;
  softnessErrorCorrection: number;
}

/** Kilograms. */
const MASSES = [1, 5, 20];

/** Contacts as springs. */
export const Softness: StoryObj<Softness> = {
  args: { softnessConstantForceMix: 0.01, softnessErrorCorrection: 0.2 },
  argTypes: {
    softnessConstantForceMix: range(0, 0.1, 0.001),
    softnessErrorCorrection: range(0.05, 1, 0.05),
  },
  parameters: {
    controls: { include: ['softnessConstantForceMix', 'softnessErrorCorrection'] },
  },
  render: ({ softnessConstantForceMix, softnessErrorCorrection }) =>
    scene(
      'Balls of 1, 5 and 20 kg drop on a mattress. It gives way: the heavier, the deeper, as softly as the collection says.',
      html`
        <x3d-collision-collection
          collidables="*"
          appliedParameters='"CONSTANT_FORCE" "ERROR_REDUCTION"'
          softnessConstantForceMix=${softnessConstantForceMix}
          softnessErrorCorrection=${softnessErrorCorrection}
        ></x3d-collision-collection>
        ${ground}
        <transform translation="0 0.5 0">
          ${shape('blue', html`<box size="7 1 2.5"></box>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        ${MASSES.map(
          (mass, i) =>
            html`<transform translation="${2.2 * (i - 1)} 1.9 0.7">
              ${shape('red', html`<sphere radius="0.5"></sphere>`)}
              <x3d-rigid-body mass=${mass}></x3d-rigid-body>
            </transform>`,
        )}
      `,
    ),
};
