// The scene of the first page: a weight on a chain that swings for ever, and boxes to throw it at.
import { html } from 'lit';
import { ground, shape, stage } from '../scene.js';

/** Of the chain, from the beam on; metres from joint to joint, radians from the vertical at which it is let go. */
const LINKS = 5;
const PITCH = 0.55;
const ANGLE = -0.9;
const TOP = { x: -1, y: 4.8 };

/** A point of the chain, `way` metres from the beam. */
const at = (way: number): string =>
  `${TOP.x + way * Math.sin(ANGLE)} ${TOP.y - way * Math.cos(ANGLE)} 0`;

const links = Array.from({ length: LINKS }, (_, i) => {
  const weight = i === LINKS - 1;
  return html`
    <transform translation=${at((i + 0.5) * PITCH)} rotation="0 0 1 ${ANGLE}">
      ${
        weight
          ? shape('red', html`<sphere radius="0.4"></sphere>`)
          : shape('brass', html`<cylinder radius="0.07" height="0.46"></cylinder>`)
      }
      <x3d-rigid-body
        id="link${i}"
        title=${weight ? 'Weight' : `Link ${i + 1}`}
        mass=${weight ? 3 : 0.2}
      ></x3d-rigid-body>
    </transform>
    <x3d-ball-joint
      body1=${i === 0 ? 'beam' : `link${i - 1}`}
      body2="link${i}"
      anchorPoint=${at(i * PITCH)}
    ></x3d-ball-joint>
  `;
});

/** A pyramid beyond the weight's swing: three, two, one. */
const boxes = [3, 2, 1]
  .flatMap((count, row) =>
    Array.from({ length: count }, (_, i) => ({ row, x: 2.9 + 0.75 * (i - (count - 1) / 2) })),
  )
  .map(
    ({ row, x }, i) =>
      html`<transform translation="${x} ${0.35 + 0.7 * row} 0">
        ${shape(row % 2 ? 'brass' : 'blue', html`<box size="0.7 0.7 0.7"></box>`)}
        <x3d-rigid-body title="Box ${i + 1}"></x3d-rigid-body>
      </transform>`,
  );

export const startScene = stage(
  'front',
  html`
    <x3d-rigid-body-collection
      default
      draggable-body
      gravity="0 -9.8 0"
    ></x3d-rigid-body-collection>
    ${ground}
    <transform translation="${TOP.x} ${TOP.y + 0.1} 0">
      ${shape('iron', html`<box size="1.4 0.2 0.6"></box>`)}
      <x3d-rigid-body id="beam" fixed></x3d-rigid-body>
    </transform>
    ${links} ${boxes}
  `,
);
