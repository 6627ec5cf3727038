import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  geometry: 'box' | 'sphere' | 'cylinder' | 'cone';
  enabled: boolean;
}

const geometries = {
  box: html`<box size="1 1 1"></box>`,
  sphere: html`<sphere radius="0.6"></sphere>`,
  cylinder: html`<cylinder radius="0.5" height="1"></cylinder>`,
  cone: html`<cone bottomRadius="0.6" height="1.2"></cone>`,
};

const meta: Meta<Args> = {
  title: 'Nodes/CollidableShape',
  tags: ['autodocs'],
  args: { geometry: 'cylinder', enabled: true },
  argTypes: { geometry: { control: 'inline-radio', options: Object.keys(geometries) } },
  render: ({ geometry, enabled }) =>
    scene(
      'The standard form: the collidable stands in the scene and is drawn there, and the body names it with use. Another geometry takes its place while it rolls.',
      html`
        <transform translation="-1 0.6 0" rotation="0 0 1 -0.3">
          ${shape('iron', html`<box size="6 0.2 3"></box>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        <transform translation="4 0.5 0">
          ${shape('iron', html`<box size="0.3 1 3"></box>`)}
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        ${ground}
        <x3d-rigid-body-collection default></x3d-rigid-body-collection>
        <x3d-rigid-body position="-3 3.5 0" orientation="1 0 0 1.3">
          <x3d-collidable-shape use="rolling"></x3d-collidable-shape>
        </x3d-rigid-body>
        <x3d-collidable-shape def="rolling" enabled=${enabled}>
          ${shape('brass', geometries[geometry])}
        </x3d-collidable-shape>
      `,
    ),
};
export default meta;

export const CollidableShape: StoryObj<Args> = {};
