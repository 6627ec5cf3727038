import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html, type TemplateResult } from 'lit';
import { logWater } from './code/log-water.js';
import { range } from './particles.js';
import { scene, shape } from './scene.js';

interface Args {
  density: number;
  dragCoefficient: number;
  damping: number;
  flow: number;
  level: number;
}

/** What falls into the pool. */
const thrown = (
  id: string,
  x: number,
  mass: number,
  look: TemplateResult,
  rotation = '0 0 1 0.3',
) => html`
  <transform translation="${x} 3 0" rotation=${rotation}>
    ${look}
    <x3d-rigid-body
      id=${id}
      mass=${mass}
      @waterenter=${logWater}
      @waterleave=${logWater}
    ></x3d-rigid-body>
  </transform>
`;

const things = html`
  ${thrown('crate', -2.2, 300, shape('brass', html`<box size="1 0.8 1"></box>`))}
  ${thrown('ball', 0, 120, shape('red', html`<sphere radius="0.45"></sphere>`))}
  ${thrown('buoy', 2.2, 80, shape('iron', html`<cone bottomRadius="0.5" height="1"></cone>`), '1 0 0 2.8')}
`;

const meta: Meta<Args> = {
  title: 'Nodes/WaterVolume',
  tags: ['autodocs'],
  args: { density: 1000, dragCoefficient: 1, damping: 1, flow: 0, level: 0 },
  argTypes: {
    density: { ...range(200, 2000, 10), description: 'kg/m³; what is denser sinks' },
    dragCoefficient: range(0, 3, 0.1),
    damping: range(0, 5, 0.1),
    flow: { ...range(-1, 1, 0.05), description: 'm/s, along x' },
    level: { ...range(-1, 0.6, 0.05), description: 'Metres: its Transform lifts it' },
  },
  render: ({ density, dragCoefficient, damping, flow, level }) =>
    scene(
      'A crate, a ball and a cone fall into a pool and float, each as deep as what it displaces weighs as much as it does. The pool is where its Transform is, and as large as the Box beside it.',
      html`
        ${things}
        <transform translation="0 ${level - 1} 0">
          <shape>
            <appearance>
              <material diffuseColor="0.03 0.3 0.42" transparency="0.5"></material>
            </appearance>
            <box size="8 2 5"></box>
          </shape>
          <x3d-water-volume
            density=${density}
            dragCoefficient=${dragCoefficient}
            damping=${damping}
            flow="${flow} 0 0"
          ></x3d-water-volume>
        </transform>
      `,
      { beside: html`<ol class="log" aria-label="Events"></ol>` },
    ),
};
export default meta;

export const WaterVolume: StoryObj<Args> = {};
