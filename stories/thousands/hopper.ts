// A hopper full of marbles above a tray.
import { html, type TemplateResult } from 'lit';
import { shape } from '../scene.js';

/** Metres. */
const CENTRE = -7.5;
const MARBLES = { count: 985, radius: 0.22, pitch: 0.5, perRow: 11, lowest: 6.6 };
/** By how much the funnel's sides lean, radians. */
const LEAN = 0.75;

const COLORS = ['0.85 0.25 0.2', '0.9 0.65 0.2', '0.2 0.55 0.75', '0.85 0.85 0.8', '0.3 0.6 0.35'];

/** Each of the four sides: its direction from the middle. */
const SIDES = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

const glass = html`
  <appearance>
    <material diffuseColor="0.55 0.65 0.75" transparency="0.75"></material>
  </appearance>
`;

function wall(place: string, size: string, rotation: string, look: TemplateResult) {
  return html`
    <transform translation=${place} rotation=${rotation}>
      <shape>
        ${look}
        <box size=${size}></box>
      </shape>
      <x3d-rigid-body fixed></x3d-rigid-body>
    </transform>
  `;
}

/** A board that stands at a side: so far out, so high up, so large. */
function board(
  [x, z]: readonly [number, number],
  [out, up]: readonly [number, number],
  [thick, high, wide]: readonly [number, number, number],
  lean = 0,
) {
  const place = `${CENTRE + x * out} ${up} ${z * out}`;
  const size = x ? `${thick} ${high} ${wide}` : `${wide} ${high} ${thick}`;
  const rotation = x ? `0 0 1 ${x * lean}` : `1 0 0 ${-z * lean}`;
  return wall(place, size, rotation, glass);
}

const walls = SIDES.flatMap((side) => [
  board(side, [2.4, 5.2], [3.4, 0.2, 7.4], LEAN),
  board(side, [3.7, 8.5], [0.2, 5, 7.6]),
  board(side, [4.2, 0.5], [0.2, 1, 8.6]),
]);

/** A little off the places of a lattice, in which they would stand upon each other. */
function marble(i: number) {
  const { radius, pitch, perRow, lowest } = MARBLES;
  const middle = (perRow - 1) / 2;
  const x = CENTRE + pitch * ((i % perRow) - middle) + 0.02 * ((i * 7) % 5);
  const z = pitch * ((Math.floor(i / perRow) % perRow) - middle) + 0.02 * ((i * 3) % 5);
  const y = lowest + pitch * Math.floor(i / perRow ** 2);
  return html`
    <transform translation="${x} ${y} ${z}">
      <shape>
        <appearance>
          <material
            diffuseColor=${COLORS[i % COLORS.length]!}
            specularColor="0.6 0.6 0.6"
            shininess="0.6"
          ></material>
        </appearance>
        <sphere radius=${radius} subdivision="12,12"></sphere>
      </shape>
      <x3d-rigid-body
        mass="0.3"
        autoDamp="true"
        linearDampingFactor="0.1"
        angularDampingFactor="0.7"
      ></x3d-rigid-body>
    </transform>
  `;
}

export const hopper = html`
  ${Array.from({ length: MARBLES.count }, (_, i) => marble(i))} ${walls}
`;

/** What comes for the pyramid when it is thrown: where it waits. */
export const ball = html`
  <transform translation="6.5 1.5 13">
    ${shape('iron', html`<sphere radius="1.2"></sphere>`)}
    <x3d-rigid-body id="ball" mass="60"></x3d-rigid-body>
  </transform>
`;
