// Boxes above a floor, close and all turned another way, so that they tumble over each other.
import { html } from 'lit';

/** Metres: no farther across than to the next one, however they are turned. */
const SIZE = 0.6;
const PITCH = 1.05;
const ALONG = 18;
const DEEP = 10;

const COLORS = ['0.03 0.3 0.42', '0.75 0.42 0.1', '0.6 0.06 0.04', '0.17 0.21 0.26'];

function box(i: number) {
  const layer = Math.floor(i / (ALONG * DEEP));
  const x = PITCH * ((i % ALONG) - (ALONG - 1) / 2) + 0.03 * (layer % 5);
  const z = PITCH * ((Math.floor(i / ALONG) % DEEP) - (DEEP - 1) / 2) + 0.03 * (layer % 3);
  const y = 1 + PITCH * layer;
  return html`
    <transform translation="${x} ${y} ${z}" rotation="1 1 0 ${0.3 * (i % 11)}">
      <shape>
        <appearance>
          <material diffuseColor=${COLORS[(i * 7 + layer) % COLORS.length]!}></material>
        </appearance>
        <box size="${SIZE} ${SIZE} ${SIZE}"></box>
      </shape>
      <x3d-rigid-body></x3d-rigid-body>
    </transform>
  `;
}

export const looseBoxes = (count: number) => Array.from({ length: count }, (_, i) => box(i));
