import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

const meta: Meta = { title: 'Shortcuts' };
export default meta;

export const BodyInsideATransform: StoryObj = {
  render: () =>
    scene(
      'A body inside a Transform moves it, and collides with the Shapes under it; the scale above them counts.',
      html`
        ${ground}
        <transform translation="0 1 0" scale="1.5 1.5 1.5">
          <transform translation="0 1.5 0" rotation="1 0 1 0.6">
            ${shape('red', html`<box size="0.8 0.8 0.8"></box>`)}
            <transform translation="0.7 0 0">
              ${shape('brass', html`<sphere radius="0.3"></sphere>`)}
            </transform>
            <x3d-rigid-body></x3d-rigid-body>
          </transform>
        </transform>
      `,
    ),
};

export const For: StoryObj = {
  name: 'for="ID"',
  render: () =>
    scene(
      'for names, from anywhere, the Transform that a body stands for, as a label names its input.',
      html`
        ${ground}
        <transform id="crate" translation="-0.3 3 0">
          ${shape('blue', html`<box size="1 1 1"></box>`)}
        </transform>
        <transform id="barrel" translation="0.3 5 0" rotation="0 0 1 0.4">
          ${shape('brass', html`<cylinder radius="0.5" height="1.2"></cylinder>`)}
        </transform>
        <x3d-rigid-body-collection default gravity="0 -9.8 0"></x3d-rigid-body-collection>
        <x3d-rigid-body for="crate"></x3d-rigid-body>
        <x3d-rigid-body for="barrel"></x3d-rigid-body>
      `,
    ),
};
