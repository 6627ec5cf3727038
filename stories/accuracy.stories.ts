import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { BRASS, chain, GHOST, PENDULUM, WHIP } from './chain.js';
import { besideReference, LEVELS } from './code/beside-reference.js';
import { pour, tellLevel } from './code/pour.js';
import kept from './kept/pendulum.json';
import { ground, scene } from './scene.js';

const meta: Meta = { title: 'Accuracy' };
export default meta;

const value = (name: string, label: string) => html`
  <div>
    <dt>${label}</dt>
    <dd data-value=${name}>–</dd>
  </div>
`;

/** One chain at the level of the slider, and where it should be. */
export const BesideReference: StoryObj = {
  render: () =>
    scene(
      'The brass chain runs at the level that the slider sets, the blue ghost at reference. Let go level it whips, and the little that a step gets wrong grows until they part: at game within seconds.',
      html`
        ${chain('level', 'game', WHIP, BRASS)}
        ${chain('ghost', 'reference', WHIP, GHOST, besideReference)}
      `,
      {
        beside: html`
          <label class="slider">
            <span>Level: <b data-value="level"></b></span>
            <input type="range" min="0" max=${LEVELS.length - 1} step="1" value="0" />
            <span class="marks" aria-hidden="true">
              ${LEVELS.map((name) => html`<span>${name}</span>`)}
            </span>
          </label>
          <dl class="values">
            ${value('time', 'Since it was let go')} ${value('drift', 'From the ghost now')}
            ${value('together', 'Within 10 cm of it for')} ${value('cost', 'Its work')}
            ${value('ghost', "The ghost's")}
          </dl>
        `,
      },
    ),
};

/** What every level costs in this scene, as it is. */
export const Chart: StoryObj = {
  render: () =>
    scene(
      'What each level costs in this scene, and how far off it is, as it was measured once; Measure does it here and now, from the state the scene is in, in a worker. The buttons set the level of the running scene.',
      html`${chain('measured', 'standard', PENDULUM, BRASS)}`,
      {
        view: 'pendulum',
        beside: html`<x3d-accuracy-chart for="measured" .measured=${kept}></x3d-accuracy-chart>`,
      },
    ),
};

/** The finest level that fits. */
export const Auto: StoryObj<{ budget: number }> = {
  args: { budget: 6 },
  argTypes: {
    budget: {
      description: 'time-budget: milliseconds of a frame that the physics may take',
      control: { type: 'range', min: 1, max: 12, step: 1 },
    },
  },
  render: ({ budget }) =>
    scene(
      'accuracy="auto" takes the finest level whose frames fit the time budget, a level per second, and says so. Pour boxes, and it comes down.',
      html`
        <x3d-rigid-body-collection
          default
          accuracy="auto"
          time-budget=${budget}
          @physicsaccuracy=${tellLevel}
        ></x3d-rigid-body-collection>
        ${ground}
      `,
      {
        buttons: html`<button type="button" @click=${pour}>Pour boxes</button>`,
        beside: html`<ol class="log" aria-label="Levels"></ol>`,
      },
    ),
};
