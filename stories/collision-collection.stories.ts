import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
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

const meta: Meta<Args> = {
  title: 'Nodes/CollisionCollection',
  args: { bounce: 0.8, minBounceSpeed: 0.1, friction: 0.3, enabled: true },
  argTypes: {
    bounce: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
    minBounceSpeed: { control: { type: 'range', min: 0, max: 5, step: 0.1 } },
    friction: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
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
