import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  axis1Torque: number;
  load: number;
}

/** Radians between the shafts. */
const ANGLE = 0.6;
const [COS, SIN] = [Math.cos(ANGLE), Math.sin(ANGLE)];

/** Metres: of each shaft, and of the joint between them above the ground. */
const LENGTH = 2.4;
const HEIGHT = 1.6;

const numbers = (...values: number[]) => values.map((value) => value.toFixed(4)).join(' ');

const END = numbers(LENGTH * COS, HEIGHT + LENGTH * SIN, 0);

/** A shaft along X with a bar through it, so that its turning shows. */
const shaft = (color: 'red' | 'brass', bar: number) => html`
  <transform rotation="0 0 1 1.5708">
    ${shape('iron', html`<cylinder radius="0.08" height="${LENGTH - 0.1}"></cylinder>`)}
  </transform>
  <transform translation="${bar} 0 0">
    ${shape(color, html`<box size="0.15 1.8 0.3"></box>`)}
  </transform>
`;

const meta: Meta<Args> = {
  title: 'Nodes/UniversalJoint',
  tags: ['autodocs'],
  args: { axis1Torque: 1.5, load: 0.1 },
  argTypes: {
    axis1Torque: { control: { type: 'range', min: -4, max: 4, step: 0.1 } },
    load: {
      control: { type: 'range', min: 0, max: 1, step: 0.05 },
      description: 'angularDampingFactor of the brass shaft',
    },
  },
  render: ({ axis1Torque, load }) =>
    scene(
      'A motor turns the red shaft. The cardan joint hands the turning on round the corner: the brass one follows, faster and slower by turns.',
      html`
        ${ground}
        <transform translation="${-LENGTH / 2} ${HEIGHT} 0">
          ${shaft('red', -0.6)}
          <x3d-rigid-body
            id="driving"
            useGlobalGravity="false"
            autoDamp="true"
            angularDampingFactor="0.3"
          ></x3d-rigid-body>
        </transform>
        <transform
          translation=${numbers((LENGTH / 2) * COS, HEIGHT + (LENGTH / 2) * SIN, 0)}
          rotation="0 0 1 ${ANGLE}"
        >
          ${shaft('brass', 0.6)}
          <x3d-rigid-body
            id="driven"
            useGlobalGravity="false"
            autoDamp="true"
            angularDampingFactor=${load}
          ></x3d-rigid-body>
        </transform>
        <x3d-universal-joint
          body1="driving"
          body2="driven"
          anchorPoint="0 ${HEIGHT} 0"
          axis1="0 0 1"
          axis2=${numbers(-SIN, COS, 0)}
        ></x3d-universal-joint>
        <x3d-single-axis-hinge-joint
          body1="driving"
          anchorPoint="${-LENGTH} ${HEIGHT} 0"
          axis="1 0 0"
        ></x3d-single-axis-hinge-joint>
        <x3d-ball-joint body1="driven" anchorPoint=${END}></x3d-ball-joint>
        <x3d-motor-joint
          body1="driving"
          motor1Axis="1 0 0"
          axis1Torque=${axis1Torque}
        ></x3d-motor-joint>
        ${[`${-LENGTH} ${HEIGHT} 0`, `0 ${HEIGHT} 0`, END].map(
          (place) =>
            html`<transform translation=${place}>
              ${shape('blue', html`<sphere radius="0.16"></sphere>`)}
            </transform>`,
        )}
      `,
    ),
};
export default meta;

export const UniversalJoint: StoryObj<Args> = {};
