// A pyramid of bricks of four looks, a colour for each brick.
import { html } from 'lit';

/** Bricks along an edge of the lowest layer: 14² + 13² + … + 1² = 1015 in all. */
const LAYERS = 14;
/** Metres. */
const CENTRE = 6.5;
const BRICK = { wide: 0.8, high: 0.4, pitch: 0.82 };

/** A joint of mortar round a brick; the rest takes the brick's colour. */
const MORTAR = `data:image/svg+xml,${encodeURIComponent(
  '<svg xmlns="http://www.w3.org/2000/svg" width="64" height="64"><rect width="64" height="64" fill="#c9bfae"/><rect x="4" y="4" width="56" height="56" fill="#a4492f"/><rect x="4" y="28" width="56" height="5" fill="#8f3d27"/></svg>',
)}`;

const material = (color: string, more: { shine?: number; glow?: string } = {}) => html`
  <material
    diffuseColor=${color}
    specularColor=${more.shine ? '0.9 0.9 0.8' : '0 0 0'}
    shininess=${more.shine ?? 0.2}
    emissiveColor=${more.glow ?? '0 0 0'}
  ></material>
`;

/** From layer to layer: clay, mortar, glaze, and what glows a little. */
const LOOKS = [
  (i: number) => material(`${0.62 + 0.03 * (i % 5)} ${0.3 + 0.02 * (i % 3)} 0.22`),
  () => html`
    ${material('1 1 1')}
    <imagetexture url=${MORTAR}></imagetexture>
  `,
  (i: number) => material(`0.12 ${0.35 + 0.04 * (i % 4)} ${0.5 + 0.05 * (i % 5)}`, { shine: 0.7 }),
  (i: number) => material(`${0.7 + 0.04 * (i % 3)} 0.5 0.15`, { glow: '0.18 0.1 0.02' }),
];

function layer(y: number) {
  const along = LAYERS - y;
  const { wide, high, pitch } = BRICK;
  const look = LOOKS[y % LOOKS.length]!;
  return Array.from({ length: along ** 2 }, (_, i) => {
    const [x, z] = [i % along, Math.floor(i / along)].map((k) => pitch * (k - (along - 1) / 2));
    return html`
      <transform translation="${CENTRE + x!} ${high * (y + 0.5)} ${z}">
        <shape>
          <appearance>${look(i)}</appearance>
          <box size="${wide} ${high} ${wide}"></box>
        </shape>
        <x3d-rigid-body></x3d-rigid-body>
      </transform>
    `;
  });
}

export const pyramid = Array.from({ length: LAYERS }, (_, y) => layer(y));
