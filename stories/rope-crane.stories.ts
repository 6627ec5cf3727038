import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { range } from './particles.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  turn: number;
  load: number;
}

const meta: Meta<Args> = {
  title: 'Crane with a rope',
  args: { turn: 0.6, load: 20 },
  argTypes: {
    turn: { ...range(-1.5, 1.5, 0.05), description: 'rad/s, of the jib' },
    load: { ...range(1, 100, 1), description: 'kg, of the crate' },
  },
  render: ({ turn, load }) =>
    scene(
      'The jib of a crane turns on its mast; a crate hangs from it by a rope of 1 kg, lags behind and swings out.',
      html`
        ${ground}
        <transform translation="0 2.4 0">
          ${shape('iron', html`<cylinder radius="0.15" height="4.8"></cylinder>`)}
          <x3d-rigid-body id="mast" fixed></x3d-rigid-body>
        </transform>
        <transform translation="0 5 0">
          ${shape('blue', html`<box size="6 0.3 0.3"></box>`)}
          <x3d-rigid-body id="jib" mass="1000" angularVelocity="0 ${turn} 0"></x3d-rigid-body>
        </transform>
        <x3d-single-axis-hinge-joint
          body1="mast"
          body2="jib"
          axis="0 1 0"
          anchorPoint="0 5 0"
        ></x3d-single-axis-hinge-joint>
        <transform translation="2.8 1.5 0">
          ${shape('red', html`<box size="0.9 0.9 0.9"></box>`)}
          <x3d-rigid-body id="crate" mass=${load}></x3d-rigid-body>
        </transform>
        <x3d-rope points="2.8 4.85 0 2.8 1.95 0" segments="24" mass="1" radius="0.035">
          ${shape('brass', html``)}
          <x3d-soft-body-attachment
            index="0"
            body="jib"
            position="2.8 -0.15 0"
          ></x3d-soft-body-attachment>
          <x3d-soft-body-attachment
            index="24"
            body="crate"
            position="0 0.45 0"
          ></x3d-soft-body-attachment>
        </x3d-rope>
      `,
      { view: 'pendulum' },
    ),
};
export default meta;

export const CraneWithARope: StoryObj<Args> = {};
