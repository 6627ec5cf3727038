import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { logDrag } from './code/log-drag.js';
import { ground, scene, shape } from './scene.js';

const meta: Meta = { title: 'Dragging' };
export default meta;

const LINKS = [0, 1, 2, 3, 4];

/** By its end, or by any link. */
export const Pendulum: StoryObj = {
  render: () =>
    scene(
      'Take the weight or any link and pull, as far as you like: the joints hold, and the chain swings on where you let go.',
      html`
        <x3d-rigid-body-collection default draggable-body></x3d-rigid-body-collection>
        <transform translation="0 4.4 0">
          ${shape('iron', html`<box size="1.2 0.2 0.6"></box>`)}
          <x3d-rigid-body id="beam" fixed></x3d-rigid-body>
        </transform>
        ${LINKS.map(
          (i) => html`
            <transform translation="0 ${4 - 0.6 * i} 0">
              ${
                i < 4
                  ? shape('brass', html`<cylinder radius="0.08" height="0.5"></cylinder>`)
                  : shape('red', html`<sphere radius="0.4"></sphere>`)
              }
              <x3d-rigid-body
                id="link${i}"
                title=${i < 4 ? `Link ${i + 1}` : 'Weight'}
                mass=${i < 4 ? 0.2 : 3}
              ></x3d-rigid-body>
            </transform>
            <x3d-ball-joint
              body1=${i === 0 ? 'beam' : `link${i - 1}`}
              body2="link${i}"
              anchorPoint="0 ${4.3 - 0.6 * i} 0"
            ></x3d-ball-joint>
          `,
        )}
      `,
    ),
};

/** Metres: a heap of boxes, by its rows. */
const heap = [5, 4, 3, 2].flatMap((count, row) =>
  Array.from({ length: count }, (_, i) => ({
    x: 0.9 * (i - (count - 1) / 2),
    y: 0.4 + 0.81 * row,
    color: (['blue', 'brass', 'red', 'iron'] as const)[(row + i) % 4]!,
  })),
);

export const Heap: StoryObj = {
  render: () =>
    scene(
      html`
        Pull boxes out, push with one into the others, throw them; drag beside the boxes to look
        around.
        <span class="with-mouse">With Shift held, up and down move a box away and nearer.</span>
      `,
      html`
        <x3d-rigid-body-collection default draggable-body></x3d-rigid-body-collection>
        ${ground}
        ${heap.map(
          ({ x, y, color }) => html`
            <transform translation="${x} ${y} 0">
              ${shape(color, html`<box size="0.8 0.8 0.8"></box>`)}
              <x3d-rigid-body></x3d-rigid-body>
            </transform>
          `,
        )}
      `,
    ),
};

const MODES = [
  { mode: 'spring', x: -2.4, color: 'red' },
  { mode: 'kinematic', x: 0, color: 'brass' },
  { mode: 'teleport', x: 2.4, color: 'blue' },
] as const;

/** The same body in all three modes. */
export const Modes: StoryObj = {
  render: () =>
    scene(
      'Red: by a spring, which heeds weight and walls. Brass: kinematically, past all forces, pushing others aside. Blue: set down where the pointer is. Escape puts brass and blue back.',
      html`
        ${ground}
        ${MODES.map(
          ({ mode, x, color }) => html`
            <transform translation="${x} 0.5 0.6">
              ${shape(color, html`<box size="1 1 1"></box>`)}
              <x3d-rigid-body
                title=${mode}
                mass="4"
                draggable-body
                drag-mode=${mode}
              ></x3d-rigid-body>
            </transform>
            <transform translation="${x} 0.3 -1.2">
              ${shape('iron', html`<box size="0.6 0.6 0.6"></box>`)}
              <x3d-rigid-body></x3d-rigid-body>
            </transform>
          `,
        )}
      `,
    ),
};

/** Without a pointer. */
export const Keyboard: StoryObj = {
  render: () =>
    scene(
      'Tab comes to the bodies, arrow keys go from one to the next. Enter takes hold: arrow keys then move it, Page Up and Page Down away and nearer, Escape cancels, Enter lets go.',
      html`
        <x3d-rigid-body-collection default draggable-body></x3d-rigid-body-collection>
        ${ground}
        ${[
          { name: 'Crate', x: -2, color: 'blue', geometry: html`<box size="1 1 1"></box>` },
          { name: 'Ball', x: 0, color: 'red', geometry: html`<sphere radius="0.5"></sphere>` },
          {
            name: 'Drum',
            x: 2,
            color: 'brass',
            geometry: html`<cylinder radius="0.5" height="1"></cylinder>`,
          },
        ].map(
          ({ name, x, color, geometry }) => html`
            <transform translation="${x} 0.5 0">
              ${shape(color as 'blue', geometry)}
              <x3d-rigid-body
                title=${name}
                @bodydragstart=${logDrag}
                @bodydragend=${logDrag}
              ></x3d-rigid-body>
            </transform>
          `,
        )}
      `,
      { beside: html`<ol class="log" aria-label="Events"></ol>` },
    ),
};
