import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { switchWay, throwBall, watchFrames } from './code/both-ways.js';
import { scene } from './scene.js';
import { ball, hopper } from './thousands/hopper.js';
import { pyramid } from './thousands/pyramid.js';

const meta: Meta = { title: 'Drawing' };
export default meta;

const WAYS = [
  ['plain', 'One by one'],
  ['batched', 'In few calls'],
] as const;

const row = (name: string, label: string) => html`
  <tr>
    <th scope="row">${label}</th>
    ${WAYS.map(([way]) => html`<td data-value="${way} ${name}">–</td>`)}
  </tr>
`;

const figures = html`
  <label class="switch">
    <input type="checkbox" role="switch" checked @change=${switchWay} />
    Draw bodies that look alike in few calls
  </label>
  <table class="figures" aria-live="off">
    <thead>
      <tr>
        <th></th>
        ${WAYS.map(([, label]) => html`<th scope="col">${label}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${row('script', 'Script to draw a frame')} ${row('draws', 'Draws in a frame')}
    </tbody>
  </table>
  <dl class="values">
    <div>
      <dt>Batches</dt>
      <dd data-value="batches">–</dd>
    </div>
    <div>
      <dt>Physics of a frame</dt>
      <dd data-value="physics">–</dd>
    </div>
  </dl>
`;

/** As many as a page of plain x3dom can't draw. */
export const TwoThousandBodies: StoryObj = {
  render: () =>
    scene(
      'A hopper of 985 marbles runs out beside 1015 bricks of four looks. Throw the ball at the pyramid; switch how they are drawn, which the picture does not show.',
      html`
        <x3d-rigid-body-collection
          default
          accuracy="game"
          iterations="8"
          autoDisable="true"
          disableTime="0.4"
          disableLinearSpeed="0.12"
          disableAngularSpeed="0.3"
          @physicsready=${watchFrames}
        ></x3d-rigid-body-collection>
        <transform translation="0 -0.5 0">
          <shape>
            <appearance><material diffuseColor="0.5 0.55 0.58"></material></appearance>
            <box size="60 1 40"></box>
          </shape>
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        ${hopper} ${pyramid} ${ball}
      `,
      {
        view: 'wide',
        buttons: html`<button type="button" @click=${throwBall}>Throw the ball</button>`,
        beside: figures,
      },
    ),
};
