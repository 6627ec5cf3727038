import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import source from './code/start-over.ts?raw';
import { startOver } from './code/start-over.js';
import { scene, shape, slab } from './scene.js';

interface Args {
  upper: boolean;
  lower: boolean;
}

const balls = [0, 1, 2, 3, 4].map((i) => `ball${i}`);

/** A collidable without a body stands still. */
const slope = (name: string, color: 'blue' | 'brass', at: string, turned: number) => html`
  <x3d-collidable-shape def=${name} translation=${at} rotation="0 0 1 ${turned}">
    ${shape(color, html`<box size="4 0.15 1.6"></box>`)}
  </x3d-collidable-shape>
`;

const use = (name: string) =>
  html`<x3d-collidable-shape use=${name} containerfield="collidables"></x3d-collidable-shape>`;

const meta: Meta<Args> = {
  title: 'Nodes/CollisionSpace',
  tags: ['autodocs'],
  parameters: { code: source },
  args: { upper: true, lower: true },
  argTypes: {
    upper: { description: 'enabled of the space with the blue slopes' },
    lower: { description: 'enabled of the space with the brass slopes' },
  },
  render: ({ upper, lower }) =>
    scene(
      'Balls roll down two pairs of slopes. Each pair is a space: switched off, it lets the balls through.',
      html`
        <x3d-rigid-body-collection @afterstep=${startOver}>
          <x3d-collision-collection containerfield="collider">
            ${balls.map(use)} ${use('floor')}
            <x3d-collision-space containerfield="collidables" enabled=${upper}>
              ${use('upper1')} ${use('upper2')}
            </x3d-collision-space>
            <x3d-collision-space containerfield="collidables" enabled=${lower}>
              ${use('lower1')} ${use('lower2')}
            </x3d-collision-space>
          </x3d-collision-collection>
          ${balls.map(
            (name, i) =>
              html`<x3d-rigid-body class="returns" position="-2.6 ${4.2 + 0.7 * i} 0">
                <x3d-collidable-shape use=${name}></x3d-collidable-shape>
              </x3d-rigid-body>`,
          )}
        </x3d-rigid-body-collection>
        <x3d-collidable-shape def="floor" translation="0 -0.5 0">${slab}</x3d-collidable-shape>
        ${balls.map(
          (name) =>
            html`<x3d-collidable-shape def=${name}>
              ${shape('red', html`<sphere radius="0.25"></sphere>`)}
            </x3d-collidable-shape>`,
        )}
        ${slope('upper1', 'blue', '-1.4 3.6 0', -0.2)} ${slope('upper2', 'blue', '1.4 2.7 0', 0.2)}
        ${slope('lower1', 'brass', '-1.4 1.8 0', -0.2)}
        ${slope('lower2', 'brass', '1.4 0.9 0', 0.2)}
      `,
      { view: 'high' },
    ),
};
export default meta;

export const CollisionSpace: StoryObj<Args> = {};
