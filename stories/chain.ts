// The paper's pendulum: eight balls on seven ball joints, the last twenty times as heavy.
import { html, nothing } from 'lit';

const D = Math.SQRT1_2;
const TOP = 8;

const LINKS = Array.from({ length: 8 }, (_, i) => ({
  i,
  at: `${i * D} ${TOP - i * D} 0`,
  /** Where it hangs on the one before. */
  anchor: `${(i - 1) * D} ${TOP - (i - 1) * D} 0`,
}));

interface Look {
  balls: string;
  rods: string;
  transparency: number;
}

export const BRASS: Look = { balls: '0.85 0.62 0.25', rods: '0.28 0.32 0.38', transparency: 0 };
export const GHOST: Look = { balls: '0.1 0.5 0.65', rods: '0.1 0.5 0.65', transparency: 0.6 };

const material = (color: string, transparency: number) => html`
  <appearance>
    <material
      diffuseColor=${color}
      transparency=${transparency}
      specularColor="0.5 0.5 0.5"
      shininess="0.5"
    ></material>
  </appearance>
`;

/** In a world of its own; `id` is the collection's, and in front of all others. `ready`: when that has started. */
export const chain = (
  id: string,
  accuracy: string,
  { balls, rods, transparency }: Look,
  ready?: (event: Event) => void,
) => html`
  ${LINKS.map(
    ({ i, at }) => html`
      <transform id="${id}-link${i}" translation=${at}>
        <shape id="${id}-ball${i}">
          ${material(balls, transparency)}
          <sphere radius=${i === 7 ? 0.2 : 0.1}></sphere>
        </shape>
        ${
          i === 0
            ? nothing
            : html`<transform translation="${-D / 2} ${D / 2} 0" rotation="0 0 1 ${Math.PI / 4}">
                <shape>
                  ${material(rods, transparency)}
                  <cylinder radius="0.025" height="1"></cylinder>
                </shape>
              </transform>`
        }
      </transform>
    `,
  )}
  <x3d-rigid-body-collection id=${id} accuracy=${accuracy} @physicsready=${ready}>
    ${LINKS.map(
      ({ i }) => html`
        <x3d-rigid-body
          id="${id}${i}"
          for="${id}-link${i}"
          mass=${i < 7 ? 0.1 : 2}
          ?fixed=${i === 0}
          useGlobalGravity=${i === 7}
        >
          <x3d-collidable-shape for="${id}-ball${i}"></x3d-collidable-shape>
        </x3d-rigid-body>
      `,
    )}
    ${LINKS.slice(1).map(
      ({ i, anchor }) => html`
        <x3d-ball-joint
          body1="${id}${i - 1}"
          body2="${id}${i}"
          anchorPoint=${anchor}
        ></x3d-ball-joint>
      `,
    )}
  </x3d-rigid-body-collection>
`;
