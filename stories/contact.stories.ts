import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import source from './code/whirl.ts?raw';
import { whirl } from './code/whirl.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  speed: number;
}

const crates = ['2.4 1.5 0', '0 1.5 2.4', '-2.4 1.5 0', '0 1.5 -2.4'].map((at, i) => ({
  name: `crate${i}`,
  at,
}));

const use = (name: string) =>
  html`<x3d-collidable-shape use=${name} containerfield="collidables"></x3d-collidable-shape>`;

const meta: Meta<Args> = {
  title: 'Nodes/Contact',
  tags: ['autodocs'],
  parameters: { code: source },
  args: { speed: 2 },
  argTypes: {
    speed: {
      control: { type: 'range', min: -4, max: 4, step: 0.1 },
      description: 'surfaceSpeed that the page writes into every contact of the disc, m/s',
    },
  },
  render: ({ speed }) =>
    scene(
      'The disc stands still, but its contacts do not. The page takes them from a sensor, gives each a direction and a speed, leaves out those in the middle, and hands the rest back by set_contacts: a whirlpool.',
      html`
        <x3d-rigid-body-collection
          default
          data-speed=${speed}
          @afterstep=${whirl}
        ></x3d-rigid-body-collection>
        <x3d-collision-sensor>
          <x3d-collision-collection containerfield="collider">
            ${use('disc')} ${crates.map(({ name }) => use(name))}
          </x3d-collision-collection>
        </x3d-collision-sensor>
        ${ground}
        <x3d-collidable-shape def="disc" translation="0 1 0">
          ${shape('iron', html`<cylinder radius="3.2" height="0.2" subdivision="64"></cylinder>`)}
        </x3d-collidable-shape>
        <transform translation="0 1.03 0">
          ${shape('blue', html`<cylinder radius="0.8" height="0.16"></cylinder>`)}
        </transform>
        ${crates.map(
          ({ name, at }, i) =>
            html`<x3d-rigid-body class="returns" position=${at}>
                <x3d-collidable-shape use=${name}></x3d-collidable-shape>
              </x3d-rigid-body>
              <x3d-collidable-shape def=${name}>
                ${shape(i % 2 ? 'red' : 'brass', html`<box size="0.6 0.5 0.6"></box>`)}
              </x3d-collidable-shape>`,
        )}
      `,
      { view: 'above' },
    ),
};
export default meta;

export const Contact: StoryObj<Args> = {};
