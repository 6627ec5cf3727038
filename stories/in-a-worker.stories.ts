import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { watchPage } from './code/in-a-worker.js';
import { scene } from './scene.js';
import { looseBoxes } from './thousands/loose.js';

const meta: Meta = { title: 'In a worker' };
export default meta;

const value = (name: string, label: string) => html`
  <div>
    <dt>${label}</dt>
    <dd data-value=${name}>–</dd>
  </div>
`;

const LINES = Array.from({ length: 60 }, (_, i) => `Line ${i + 1}`);

const toTry = html`
  <label class="field">
    Write here while they fall
    <input type="text" autocomplete="off" />
  </label>
  <ol class="to-scroll" tabindex="0" aria-label="A list to scroll">
    ${LINES.map((line) => html`<li>${line}</li>`)}
  </ol>
  <dl class="values" aria-live="off">
    ${value('thread', 'Steps are taken by')} ${value('page', "Physics on this page's thread")}
    ${value('worker', 'Physics in the worker')} ${value('missed', 'Frames missed in 2 s')}
    ${value('longest', 'Longest wait for a frame')} ${value('awake', 'Boxes awake')}
  </dl>
`;

/** What a page feels of many bodies, on its own thread and on another. */
export const ManyBoxes: StoryObj<{ boxes: number; thread: string }> = {
  args: { boxes: 600, thread: 'worker' },
  argTypes: {
    boxes: {
      description: 'How many fall',
      control: { type: 'range', min: 200, max: 2000, step: 100 },
    },
    thread: {
      description: 'thread: where the steps are taken; the boxes are poured again',
      control: 'inline-radio',
      options: ['main', 'worker'],
    },
  },
  render: ({ boxes, thread }) =>
    scene(
      'Boxes fall, again and again, and a worker takes the steps: write, scroll and turn the view meanwhile. Then let the page take them, by the control thread.',
      html`
        <x3d-rigid-body-collection
          default
          accuracy="game"
          thread=${thread}
          @physicsready=${watchPage}
        ></x3d-rigid-body-collection>
        <transform translation="0 -0.5 0">
          <shape>
            <appearance><material diffuseColor="0.5 0.55 0.58"></material></appearance>
            <box size="60 1 40"></box>
          </shape>
          <x3d-rigid-body fixed></x3d-rigid-body>
        </transform>
        ${looseBoxes(boxes)}
      `,
      { view: 'wide', beside: toTry },
    ),
};
