// Balls on ball joints, a metre apart, the last twenty times as heavy, in worlds of their own.
import { html, nothing } from 'lit';

interface Hang {
  /** How many balls hang below the fixed one. */
  count: number;
  /** Metres above the ground. */
  top: number;
  /** Radians below the horizontal at which it is let go. */
  slope: number;
  /** Gravity acts on all, or on the last only. */
  allFall: boolean;
}

/** The paper's pendulum, which keeps on swinging as it began. */
export const PENDULUM: Hang = { count: 7, top: 8, slope: Math.PI / 4, allFall: false };

/** Let go level it whips, and what little a step gets wrong grows tenfold in a second or two. */
export const WHIP: Hang = { count: 4, top: 3, slope: 0, allFall: true };

interface Look {
  balls: string;
  rods: string;
  transparency: number;
}

export const BRASS: Look = { balls: '0.95 0.45 0.03', rods: '0.28 0.32 0.38', transparency: 0 };
export const GHOST: Look = { balls: '0.1 0.6 0.8', rods: '0.1 0.6 0.8', transparency: 0.5 };

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

/** `id` is the collection's, and in front of all others. `ready`: when its world has started. */
export function chain(
  id: string,
  accuracy: string,
  { count, top, slope, allFall }: Hang,
  { balls, rods, transparency }: Look,
  ready?: (event: Event) => void,
) {
  const [along, down] = [Math.cos(slope), Math.sin(slope)];
  const at = (i: number): string => `${i * along} ${top - i * down} 0`;
  const indices = Array.from({ length: count + 1 }, (_, i) => i);
  const rod = html`
    <transform translation="${-along / 2} ${down / 2} 0" rotation="0 0 1 ${Math.PI / 2 - slope}">
      <shape>
        ${material(rods, transparency)}
        <cylinder radius="0.025" height="1"></cylinder>
      </shape>
    </transform>
  `;
  return html`
    ${indices.map(
      (i) => html`
        <transform id="${id}-link${i}" translation=${at(i)}>
          <shape id="${id}-ball${i}">
            ${material(balls, transparency)}
            <sphere radius=${i === count ? 0.25 : 0.15}></sphere>
          </shape>
          ${i === 0 ? nothing : rod}
        </transform>
      `,
    )}
    <x3d-rigid-body-collection id=${id} accuracy=${accuracy} @physicsready=${ready}>
      ${indices.map(
        (i) => html`
          <x3d-rigid-body
            id="${id}${i}"
            class=${i === count ? 'end' : nothing}
            for="${id}-link${i}"
            mass=${i < count ? 0.1 : 2}
            ?fixed=${i === 0}
            useGlobalGravity=${allFall || i === count}
          >
            <x3d-collidable-shape for="${id}-ball${i}"></x3d-collidable-shape>
          </x3d-rigid-body>
        `,
      )}
      ${indices
        .slice(1)
        .map(
          (i) => html`
            <x3d-ball-joint
              body1="${id}${i - 1}"
              body2="${id}${i}"
              anchorPoint=${at(i - 1)}
            ></x3d-ball-joint>
          `,
        )}
    </x3d-rigid-body-collection>
  `;
}
