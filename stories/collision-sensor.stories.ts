import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import source from './code/light-touched.ts?raw';
import { lightTouched } from './code/light-touched.js';
import { ground, scene, shape } from './scene.js';

interface Args {
  enabled: boolean;
  torque: number;
}

/** Metres from the middle. */
const RADIUS = 2.4;
const plates = [0, 1, 2, 3].map((i) => {
  const angle = (i * Math.PI) / 2;
  const [x, z] = [RADIUS * Math.cos(angle), RADIUS * Math.sin(angle)];
  return { name: `plate${i}`, at: `${x.toFixed(2)} 0 ${z.toFixed(2)}` };
});

const meta: Meta<Args> = {
  title: 'Nodes/CollisionSensor',
  tags: ['autodocs'],
  parameters: { code: source },
  args: { enabled: true, torque: 4 },
  argTypes: {
    torque: {
      control: { type: 'range', min: -10, max: 10, step: 0.5 },
      description: 'axis1Torque of the motor that turns the arm, newton metres',
    },
  },
  render: ({ enabled, torque }) =>
    scene(
      'A ball is led round over four plates. The sensor tells which collidables touch: that plate lights up.',
      html`
        <x3d-rigid-body-collection default @afterstep=${lightTouched}></x3d-rigid-body-collection>
        <x3d-collision-sensor enabled=${enabled}>
          <x3d-collision-collection containerfield="collider">
            <x3d-collidable-shape use="ball" containerfield="collidables"></x3d-collidable-shape>
            ${plates.map(
              ({ name }) =>
                html`<x3d-collidable-shape
                  use=${name}
                  containerfield="collidables"
                ></x3d-collidable-shape>`,
            )}
          </x3d-collision-collection>
        </x3d-collision-sensor>
        ${plates.map(
          ({ name, at }) =>
            html`<x3d-collidable-shape def=${name} class="plate" translation=${at}>
              ${shape('blue', html`<cylinder radius="0.8" height="0.1"></cylinder>`)}
            </x3d-collidable-shape>`,
        )}
        ${ground}
        <x3d-rigid-body id="roller" position="${RADIUS} 0.42 0">
          <x3d-collidable-shape use="ball"></x3d-collidable-shape>
        </x3d-rigid-body>
        <x3d-collidable-shape def="ball">
          ${shape('brass', html`<sphere radius="0.35"></sphere>`)}
        </x3d-collidable-shape>
        <transform translation="${RADIUS / 2} 0.7 0" rotation="0 0 1 -0.23">
          <transform rotation="0 0 1 1.5708">
            ${shape('iron', html`<cylinder radius="0.07" height="${RADIUS}"></cylinder>`)}
          </transform>
          <x3d-rigid-body id="arm" autoDamp="true" angularDampingFactor="0.9"></x3d-rigid-body>
        </transform>
        <x3d-ball-joint body1="arm" anchorPoint="0 0.98 0"></x3d-ball-joint>
        <x3d-ball-joint body1="arm" body2="roller" anchorPoint="${RADIUS} 0.42 0"></x3d-ball-joint>
        <x3d-motor-joint body2="arm" motor1Axis="0 -1 0" axis1Torque=${torque}></x3d-motor-joint>
      `,
      { view: 'above', after: html`<p>Contacts: <output aria-live="off">0</output></p>` },
    ),
};
export default meta;

export const CollisionSensor: StoryObj<Args> = {};
