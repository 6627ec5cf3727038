// Two scenes grow by a script, which copies a piece of their page. The playground runs none: there they stand as they are
// when some copies have come, each written out.

type Attributes = Record<string, string>;

/** By a tag's name, in our spelling and in X3D's own; what each copy has there. */
type Copy = Record<string, Attributes>;

const TAG: Record<string, string> = {
  transform: 'transform',
  box: 'box',
  material: 'material',
  body: 'x3d-rigid-body|RigidBody',
  hinge: 'x3d-single-axis-hinge-joint|SingleAxisHingeJoint',
};

const text = (...numbers: number[]): string =>
  numbers.map((number) => Number(number.toFixed(6))).join(' ');

const written = (attributes: Attributes): string =>
  Object.entries(attributes)
    .map(([name, value]) => ` ${name}="${value}"`)
    .join('');

const filled = (piece: string, copy: Copy): string =>
  Object.entries(copy).reduce(
    (markup, [tag, attributes]) =>
      markup.replace(
        new RegExp(`<(${TAG[tag]})(?=[\\s/>])`, 'i'),
        (start) => start + written(attributes),
      ),
    piece,
  );

// ---- a room of boxes ------------------------------------------------------------------------------------------------

const COLORS = ['0.82 0.28 0.2', '0.9 0.66 0.25', '0.25 0.58 0.6', '0.22 0.36 0.55'];
/** Boxes along each side of a layer, and metres between their middles. */
const SIDE = 4;
const APART = 1.6;
const LAYERS = 3;

/** Metres by which every other layer is moved aside, so that no tower comes to stand. */
const ASIDE = 0.5;

/** Layer over layer, above the ball. */
const boxes = (): Copy[] =>
  Array.from({ length: SIDE * SIDE * LAYERS }, (_, i) => {
    const size = 0.5 + ((i * 7) % 11) / 20;
    const [column, row, layer] = [i, i / SIDE, i / SIDE ** 2].map(Math.floor) as [
      number,
      number,
      number,
    ];
    const place = (at: number): number =>
      ((at % SIDE) - (SIDE - 1) / 2) * APART + (layer % 2) * ASIDE;
    return {
      transform: { translation: text(place(column), 4 + 1.5 * layer, place(row)) },
      material: { diffuseColor: COLORS[(column + row) % COLORS.length]! },
      box: { size: text(size, size, size) },
      body: { mass: text(2 * size ** 3) },
    };
  });

// ---- a growing chain ------------------------------------------------------------------------------------------------

const LINKS = 40;
/** Metres from link to link, and from one round of the spiral to the next. */
const PITCH = 0.5;
const ROUND = 1;
/** Sideways speed of a link, m/s: they slide until they rest. */
const SPEED = 0.3;

/** Along Archimedes' spiral, from the link that the page has. */
function links(): Copy[] {
  let [x, z, heading] = [1, 0, 0];
  return Array.from({ length: LINKS }, (_, i) => {
    heading += PITCH / Math.sqrt(((i + 1) * PITCH * ROUND) / Math.PI + 1);
    const ahead = [Math.cos(heading), -Math.sin(heading)] as const;
    const at = (way: number): string => text(x + way * ahead[0], 0.1, z + way * ahead[1]);
    const aside = i % 2 ? SPEED : -SPEED;
    const copy: Copy = {
      transform: { translation: at(PITCH), rotation: text(0, 1, 0, heading) },
      body: {
        id: `link${i + 1}`,
        linearVelocity: text(-aside * ahead[1], 0, aside * ahead[0]),
      },
      hinge: { body1: `link${i}`, body2: `link${i + 1}`, anchorPoint: at(PITCH / 2) },
    };
    [x, z] = [x + PITCH * ahead[0], z + PITCH * ahead[1]];
    return copy;
  });
}

const GROWN: readonly [page: RegExp, copies: () => Copy[]][] = [
  [/^room-of-boxes\./, boxes],
  [/^growing-chain\./, links],
];

const PIECE = /<template>\n([^]*?)\n *<\/template>/;

/** The page of a scene that grows, grown. */
export function grown(name: string, page: string): string {
  const [, copies] = GROWN.find(([pattern]) => pattern.test(name)) ?? [];
  const [, piece] = PIECE.exec(page) ?? [];
  if (!copies || !piece) return page;
  const all = copies().map((copy) => filled(piece.replace(/^ {8}/gm, ' '.repeat(12)), copy));
  return page
    .replace(/ data-count="\d+"/, '')
    .replace(/\n *<\/scene>/i, (end) => `\n${all.join('\n')}${end}`);
}
