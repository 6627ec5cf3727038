/** One thing of a scene, in words that all libraries have; metres, kilograms, radians. */
export interface Thing {
  name: string;
  /** Edges of a box, or the radius of a ball. */
  shape: readonly [number, number, number] | number;
  position: readonly [number, number, number];
  /** About Y. */
  turn?: number;
  /** 0: it stands still, and is not drawn. */
  mass: number;
  color: readonly [number, number, number];
  /** A torque about Y, newton metres, and what damps its spin. */
  motor?: number;
  damping?: number;
}

/** A hinge about Y. */
export interface Hinge {
  bodies: readonly [Thing, Thing];
  anchor: readonly [number, number, number];
}

export interface PageScene {
  things: readonly Thing[];
  hinges: readonly Hinge[];
  /** Where it is looked at from, straight ahead or from above. */
  eye: readonly [number, number, number];
  down?: boolean;
}

const COLORS = [
  [0.82, 0.28, 0.2],
  [0.9, 0.66, 0.25],
  [0.25, 0.58, 0.6],
  [0.22, 0.36, 0.55],
  [0.86, 0.83, 0.76],
] as const;

const color = (i: number) => COLORS[i % COLORS.length]!;

const still = (name: string, shape: Thing['shape'], ...position: [number, number, number]) =>
  ({ name, shape, position, mass: 0, color: COLORS[4] }) satisfies Thing;

/** Metres from the middle to a wall, and kg/m³: light enough for the ball to stir. */
const HALF = 5;
const DENSITY = 2;

/** The walls are as high as what falls: no lid. */
const room = (height: number): Thing[] => [
  still('floor', [12, 1, 12], 0, -0.5, 0),
  still('left', [1, height, 12], -HALF - 0.5, height / 2, 0),
  still('right', [1, height, 12], HALF + 0.5, height / 2, 0),
  still('back', [10, height, 1], 0, height / 2, -HALF - 0.5),
  still('front', [10, height, 1], 0, height / 2, HALF + 0.5),
];

/** Boxes of a layer, metres from one to the next, and from layer to layer. */
const [ROW, PITCH, LAYER] = [8, 1.2, 1.1];

function fallingBoxes(count: number): Thing[] {
  let state = 1;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  const middle = (ROW - 1) / 2;
  return Array.from({ length: count }, (_, i) => {
    const size = 0.5 + 0.5 * random();
    const [column, row, layer] = [i % ROW, Math.floor(i / ROW) % ROW, Math.floor(i / ROW ** 2)];
    return {
      name: `b${i}`,
      shape: [size, size, size],
      position: [PITCH * (column - middle), 2.6 + LAYER * layer, PITCH * (row - middle)],
      mass: DENSITY * size ** 3,
      color: color(i),
    };
  });
}

const BALL: Thing = {
  name: 'ball',
  shape: 1,
  position: [1, 1, 0],
  mass: 20,
  color: COLORS[0],
  motor: 500,
  damping: 0.9,
};

/** Scene 3 of the paper: a ball, turned by a motor, among boxes that fall into a room. */
export function boxes(count: number): PageScene {
  const height = 4 + LAYER * Math.ceil(count / ROW ** 2);
  return {
    things: [...fallingBoxes(count), BALL, ...room(height)],
    hinges: [],
    eye: [0, height / 2, 12 + height],
  };
}

/** Boxes that fall, and nothing else. */
export const falling = (count: number): PageScene => ({
  things: fallingBoxes(count),
  hinges: [],
  eye: [0, 4, 16],
});

/** Metres from link to link, and from one round of the spiral to the next. */
const [LINK, ROUND] = [0.5, 1];

/** Scene 4 of the paper: hinged pieces in a spiral, here dropped onto the ground together. */
export function links(count: number): PageScene {
  const things: Thing[] = [];
  const hinges: Hinge[] = [];
  let [x, z, turn] = [1, 0, Math.PI / 2];
  for (let i = 0; i <= count; i++) {
    const link: Thing = {
      name: `b${i}`,
      shape: [0.4, 0.2, 0.2],
      position: [x, 0.3, z],
      turn,
      mass: 0.5,
      color: color(i),
    };
    const last = things.at(-1);
    if (last)
      hinges.push({
        bodies: [last, link],
        anchor: [(x + last.position[0]) / 2, 0.3, (z + last.position[2]) / 2],
      });
    things.push(link);
    // Archimedes' spiral: the radius after so many links.
    turn += LINK / Math.sqrt(((i + 1) * LINK * ROUND) / Math.PI + 1);
    x += LINK * Math.cos(turn);
    z -= LINK * Math.sin(turn);
  }
  const out = Math.sqrt((count * LINK * ROUND) / Math.PI + 1);
  const ground = still('ground', [200, 1, 200], 0, -0.5, 0);
  return { things: [...things, ground], hinges, eye: [0, 3 * out + 4, 0], down: true };
}

/** By how the address of a page names them. */
export const SCENES: Record<string, (count: number) => PageScene> = { boxes, links, falling };
