import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { castRay } from './code/cast-ray.js';
import { log } from './code/log.js';
import { putBack, save, throwBall } from './code/save.js';
import chain from './pages/growing-chain.html?raw';
import pendulum from './pages/pendulum.html?raw';
import pendulumAndMotor from './pages/pendulum-and-motor.html?raw';
import room from './pages/room-of-boxes.html?raw';
import { page } from './page.js';
import { ground, scene, shape } from './scene.js';

const meta: Meta = { title: 'Looking in' };
export default meta;

/** What happens to a body. */
export const Events: StoryObj<{ bounce: number }> = {
  args: { bounce: 0.5 },
  argTypes: { bounce: { control: { type: 'range', min: 0, max: 0.9, step: 0.05 } } },
  render: ({ bounce }) =>
    scene(
      'Bodies tell when they begin and cease to touch, when they fall asleep and when they wake. Throw the ball again.',
      html`
        <x3d-collision-collection
          collidables="*"
          appliedParameters='"BOUNCE"'
          bounce=${bounce}
        ></x3d-collision-collection>
        <transform translation="0 -0.5 0">
          ${shape('iron', html`<box size="12 1 12"></box>`)}
          <x3d-rigid-body id="floor" fixed></x3d-rigid-body>
        </transform>
        <transform translation="1.5 0.5 0">
          ${shape('blue', html`<box size="1 1 1"></box>`)}
          <x3d-rigid-body id="crate" @sleep=${log} @wake=${log}></x3d-rigid-body>
        </transform>
        <transform translation="-4 1.2 0">
          ${shape('red', html`<sphere radius="0.4"></sphere>`)}
          <x3d-rigid-body
            id="ball"
            linearVelocity="4 2 0"
            autoDamp="true"
            linearDampingFactor="0.4"
            angularDampingFactor="0.4"
            @collisionstart=${log}
            @collisionend=${log}
            @sleep=${log}
            @wake=${log}
          ></x3d-rigid-body>
        </transform>
      `,
      {
        buttons: html`<button type="button" @click=${throwBall}>Throw</button>`,
        beside: html`<ol class="log" aria-label="Events"></ol>`,
      },
    ),
};

/** Metres: where each hangs, how high, and its speed at the lowest point. */
const pendulums = [
  { x: -2.2, top: 3.6, speed: -3 },
  { x: 0, top: 3.1, speed: 2.5 },
  { x: 2.2, top: 2.6, speed: -2 },
];

/** What lies on a line. */
export const Raycast: StoryObj = {
  render: () =>
    scene(
      'Three plates swing through a beam. After each step the page asks what the beam meets first: it ends there, and that plate lights up.',
      html`
        <x3d-rigid-body-collection default @afterstep=${castRay}></x3d-rigid-body-collection>
        ${ground}
        <transform id="beam" translation="0 1.3 0">
          <shape>
            <appearance>
              <material diffuseColor="0 0 0" emissiveColor="1 0.2 0.1"></material>
            </appearance>
            <box size="1 0.04 0.04"></box>
          </shape>
        </transform>
        ${pendulums.map(
          ({ x, top, speed }, i) => html`
            <transform class="plate" translation="${x} 1.4 0">
              ${shape('brass', html`<box size="0.3 1 0.8"></box>`)}
              <transform translation="0 ${(top - 0.9) / 2} 0">
                ${shape('brass', html`<box size="0.06 ${top - 1.9} 0.06"></box>`)}
              </transform>
              <x3d-rigid-body id="plate${i}" linearVelocity="0 0 ${speed}"></x3d-rigid-body>
            </transform>
            <x3d-single-axis-hinge-joint
              body1="plate${i}"
              anchorPoint="${x} ${top} 0"
              axis="1 0 0"
            ></x3d-single-axis-hinge-joint>
          `,
        )}
      `,
    ),
};

/** Rows of crates, each upon the gaps of the one below. */
const crates = [4, 3, 2, 1].flatMap((count, row) =>
  Array.from({ length: count }, (_, i) => {
    const x = 1 + 0.85 * (i - (count - 1) / 2);
    return html`<transform translation="${x} ${0.4 + 0.8 * row} 0">
      ${shape(row % 2 ? 'brass' : 'blue', html`<box size="0.8 0.8 0.8"></box>`)}
      <x3d-rigid-body></x3d-rigid-body>
    </transform>`;
  }),
);

/** A state to come back to. */
export const Snapshot: StoryObj = {
  render: () =>
    scene(
      'Save the world at any moment, throw the ball, put everything back, velocities included.',
      html`
        ${ground}${crates}
        <transform translation="-4 0.5 0">
          ${shape('red', html`<sphere radius="0.5"></sphere>`)}
          <x3d-rigid-body id="ball" mass="6"></x3d-rigid-body>
        </transform>
      `,
      {
        buttons: html`
          <button type="button" @click=${save}>Save</button>
          <button type="button" @click=${throwBall}>Throw</button>
          <button type="button" @click=${putBack}>Put back</button>
        `,
        after: html`<p><output>Nothing saved yet.</output></p>`,
      },
    ),
};

const SCENES = {
  Pendulum: pendulum,
  'Pendulum and motor': pendulumAndMotor,
  'Room of boxes': room,
  'Growing chain': chain,
};

/** One of the scenes with a monitor beside it. */
export const Monitor: StoryObj<{ scene: keyof typeof SCENES }> = {
  args: { scene: 'Pendulum and motor' },
  argTypes: { scene: { control: 'select', options: Object.keys(SCENES) } },
  render: ({ scene: name }) => {
    const main = page(SCENES[name]);
    const monitor = document.createElement('x3d-physics-monitor');
    main.querySelector('.stage, x3d')!.after(monitor);
    return main;
  },
};

/** What Bullet has, in lines. */
export const DebugDrawing: StoryObj<{ debug: boolean }> = {
  args: { debug: true },
  render: ({ debug }) =>
    scene(
      'With debug on its collection a world is drawn as Bullet has it: shapes (green awake, blue asleep, grey fixed), centres of mass, joints with their stops, contacts with their normals. The barbell collides as its parts do, the wedge as its hull.',
      html`
        <x3d-rigid-body-collection default debug=${debug}></x3d-rigid-body-collection>
        ${ground}
        <transform translation="-3 0.5 0">
          ${shape('blue', html`<box size="1 1 1"></box>`)}
          <x3d-rigid-body></x3d-rigid-body>
        </transform>
        <transform translation="-1.2 2 0" rotation="0 0 1 0.9">
          <transform translation="0 0.7 0"
            >${shape('iron', html`<sphere radius="0.4"></sphere>`)}</transform
          >
          ${shape('brass', html`<cylinder radius="0.1" height="1.4"></cylinder>`)}
          <transform translation="0 -0.7 0"
            >${shape('iron', html`<box size="0.5 0.5 0.5"></box>`)}</transform
          >
          <x3d-rigid-body></x3d-rigid-body>
        </transform>
        <transform translation="1 1.5 0" rotation="1 0 0 0.5">
          ${shape(
            'brass',
            html`<indexedfaceset
              solid="false"
              coordIndex="0 1 2 -1 3 5 4 -1 0 3 4 1 -1 1 4 5 2 -1 2 5 3 0 -1"
              ><coordinate
                point="-0.6 -0.4 0.5, 0.6 -0.4 0.5, -0.6 0.5 0.5, -0.6 -0.4 -0.5, 0.6 -0.4 -0.5, -0.6 0.5 -0.5"
              ></coordinate
            ></indexedfaceset>`,
          )}
          <x3d-rigid-body></x3d-rigid-body>
        </transform>
        <transform translation="3.3 2.5 0">
          ${shape('red', html`<box size="1.6 0.25 0.5"></box>`)}
          <x3d-rigid-body id="flap" autoDamp="true" angularDampingFactor="0.3"></x3d-rigid-body>
        </transform>
        <x3d-single-axis-hinge-joint
          body1="flap"
          anchorPoint="2.5 2.5 0"
          axis="0 0 1"
          minAngle="-1.2"
          maxAngle="0.4"
          stopBounce="0.6"
        ></x3d-single-axis-hinge-joint>
      `,
      { after: html`<x3d-physics-monitor></x3d-physics-monitor>` },
    ),
};
