// How a scene looks when it begins, light and dark: no face is black, no body is cut off, each stands out from what is behind it.
import type { Page as Tab } from 'playwright';
import { colorAt, distance, shareApart, shareBelow, type Picture } from './picture.js';
import type { Scene } from './sources.js';

/** Pixels: as wide as a page's text, and that of a phone. */
export const WIDTH = 688;
export const NARROW = 342;

/** Of 255: what is no brighter is black. */
const BLACK = 40;
/** Share of a picture that may be. */
const BLACK_SHARE = 0.0005;

/** How far a body's colour is from the one behind it: black and white are 441 from each other. */
const CONTRAST = 40;
/** Share of the bodies' shapes that may be behind something else, or come into the picture while it begins. */
const EXCEPTIONS = 0.1;

/** Share of a picture that particles take at least, when they have been born for some time. */
const PARTICLES_SHARE = 0.001;
/** Seconds. */
const SOME_TIME = 1;

/** Where a shape is in the picture: from -1 to 1, rightwards and upwards. */
interface Place {
  name: string;
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/**
 * Runs in the page: its worlds stand where they began. Keeps the shapes of bodies that can move, and what is drawn
 * otherwise: particle systems, cloth and soft bodies.
 */
const begin = (library: string): string => `(async () => {
  const { explain, worldOf } = globalThis.X3DPhysics ?? await import('${library}');
  const all = [...document.querySelectorAll('x3d *')];
  const worlds = [...new Set(all.map(worldOf).filter(Boolean))];
  await Promise.all(worlds.map(({ ready }) => ready));
  for (const world of worlds) {
    world.paused = true;
    world.reset();
  }
  globalThis.systems = all.filter((element) =>
    /^(ParticleSystem|Cloth|SoftBody)$/.test(explain(element).type ?? ''));
  const moves = (element) => {
    const { type, fields } = explain(element);
    return /^(RigidBody|CollidableShape)$/.test(type) && !fields.fixed;
  };
  const drawn = (node) => node?._cf?.geometry && node._vf.render;
  globalThis.shapes = all.filter((element) => drawn(element._x3domNode) && moves(element));
})()`;

/** Runs in the page: x3dom draws in the next frame what is asked for in this one. */
const DRAW = `(async () => {
  const { doc } = document.querySelector('x3d').runtime.canvas;
  for (let i = 0; i < 3; i++) {
    doc.needRender = 1;
    await new Promise(requestAnimationFrame);
  }
})()`;

/** Runs in the page. */
const PLACES = `(() => {
  const view = document.querySelector('x3d').runtime.canvas.doc._viewarea.getWCtoCCMatrix();
  const { SFVec3f } = x3dom.fields;
  return shapes.map((element) => {
    const node = element._x3domNode;
    const { min, max } = node.getVolume();
    const matrix = view.mult(node.getCurrentTransform());
    const corners = Array.from({ length: 8 }, (_, i) =>
      matrix.multFullMatrixPnt(new SFVec3f(...['x', 'y', 'z'].map((axis, k) => (i >> k & 1 ? max : min)[axis]))));
    const [xs, ys] = ['x', 'y'].map((axis) => corners.map((corner) => corner[axis]));
    return {
      name: node._cf.geometry.node.typeName().toLowerCase(),
      left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys),
    };
  });
})()`;

async function places(tab: Tab): Promise<Place[]> {
  await tab.evaluate(DRAW);
  return (await tab.evaluate(PLACES)) as Place[];
}

/** What `begin` keeps. */
type Kept = 'shapes' | 'systems';

/** Runs in the page: whether they are drawn. */
const render = (kept: Kept, shown: boolean): string =>
  `for (const element of ${kept}) element.setAttribute('render', '${shown}')`;

/** Runs in the page. */
const GO_ON = `(() => {
  for (const world of new Set(systems.map((system) => system.world))) world.advance(${SOME_TIME});
})()`;

const inside = (a: number, b: number): boolean => Math.max(Math.abs(a), Math.abs(b)) <= 1;

const whole = ({ left, right, bottom, top }: Place): boolean =>
  inside(left, right) && inside(bottom, top);

const unseen = ({ left, right, bottom, top }: Place): boolean =>
  left > 1 || right < -1 || bottom > 1 || top < -1;

function cropped(all: Place[]): string[] {
  const cut = all.filter((place) => !whole(place) && !unseen(place));
  if (all.every(unseen)) return ['no body is in the picture'];
  const names = cut.map(({ name }) => name).join(', ');
  return cut.length > EXCEPTIONS * all.length
    ? [`cut off by the edge of the picture: ${names}`]
    : [];
}

/** From the middle of a shape, as shares of its width and height: a line may be drawn across the one or the other. */
const LOOKED_AT = [
  [0, 0],
  [0.2, 0.1],
  [-0.2, 0.1],
  [0.1, -0.2],
  [-0.1, -0.2],
] as const;

/** How far what is seen about the middle of a shape is from what is seen there without any. */
function contrast({ left, right, bottom, top }: Place, { shown, hidden }: Look): number {
  const far = LOOKED_AT.map(([aside, up]) => {
    const x = (left + right) / 2 + aside * (right - left);
    const y = (bottom + top) / 2 + up * (top - bottom);
    const at = [((x + 1) / 2) * (shown.width - 1), ((1 - y) / 2) * (shown.height - 1)] as const;
    return distance(colorAt(shown, ...at), colorAt(hidden, ...at));
  });
  return Math.max(...far);
}

function lost(all: Place[], look: Look): string[] {
  const seen = all.filter(whole);
  const faint = seen
    .map((place) => ({ name: place.name, far: contrast(place, look) }))
    .filter(({ far }) => far < CONTRAST);
  const names = faint.map(({ name, far }) => `${name} (${far.toFixed()})`).join(', ');
  return faint.length > EXCEPTIONS * seen.length
    ? [`hardly seen before what is behind: ${names}`]
    : [];
}

/** With what is looked at, and without. */
interface Look {
  scheme: 'light' | 'dark';
  shown: Picture;
  hidden: Picture;
}

async function looks(
  tab: Tab,
  read: (png: Buffer) => Promise<Picture>,
  kept: Kept,
): Promise<Look[]> {
  const picture = async (colorScheme: Look['scheme']): Promise<Picture> => {
    await tab.emulateMedia({ colorScheme });
    return read(await tab.locator('x3d canvas').first().screenshot());
  };
  const shown = { light: await picture('light'), dark: await picture('dark') };
  await tab.evaluate(render(kept, false));
  await tab.evaluate(DRAW);
  const hidden = { dark: await picture('dark'), light: await picture('light') };
  await tab.evaluate(render(kept, true));
  return [
    { scheme: 'dark', shown: shown.dark, hidden: hidden.dark },
    { scheme: 'light', shown: shown.light, hidden: hidden.light },
  ];
}

/** A chart that gets its figures takes room from the picture: places and pictures of one size are kept. */
const TRIES = 5;

async function placedLooks(
  tab: Tab,
  read: (png: Buffer) => Promise<Picture>,
  tries = TRIES,
): Promise<{ wide: Place[]; seen: Look[] }> {
  const before = await sizeOf(tab);
  const wide = await places(tab);
  if (wide.length === 0) return { wide, seen: [] };
  const seen = await looks(tab, read, 'shapes');
  if (before === (await sizeOf(tab))) return { wide, seen };
  if (tries === 1) throw new Error('its picture goes on changing its size');
  return placedLooks(tab, read, tries - 1);
}

const sizeOf = async (tab: Tab): Promise<string> =>
  JSON.stringify(await tab.locator('x3d canvas').first().boundingBox());

/** By night the sky is as dark as a black face; the faces are those of the day. */
function blackened({ scheme, shown }: Look): string[] {
  const share = scheme === 'light' ? shareBelow(shown, BLACK) : 0;
  return share > BLACK_SHARE ? [`${(100 * share).toFixed(2)} % of the picture is black`] : [];
}

/** Of bodies that can move. */
const wrongShapes = (narrow: Place[], wide: Place[], seen: Look[]): string[] => [
  ...cropped(narrow).map((fault) => `on a phone, ${fault}`),
  ...cropped(wide),
  ...seen.flatMap((look) =>
    [...blackened(look), ...lost(wide, look)].map((fault) => `${look.scheme}: ${fault}`),
  ),
];

/** Particles may fly out of the picture, and the last ones fade: enough of them are seen. */
async function wrongParticles(
  tab: Tab,
  read: (png: Buffer) => Promise<Picture>,
): Promise<string[]> {
  await tab.evaluate(GO_ON);
  await tab.evaluate(DRAW);
  const seen = await looks(tab, read, 'systems');
  const few = ({ shown, hidden }: Look): boolean =>
    shareApart(shown, hidden, CONTRAST) < PARTICLES_SHARE;
  return seen
    .filter(few)
    .map(({ scheme }) => `${scheme}: particles, or what gives way, are hardly seen`);
}

/** Of a scene that runs, in a tab as wide as a phone. */
export async function ugly(
  tab: Tab,
  { library, height }: Scene,
  read: (png: Buffer) => Promise<Picture>,
): Promise<string[]> {
  await tab.evaluate(begin(library));
  const narrow = await places(tab);
  await tab.setViewportSize({ width: WIDTH, height });
  const { wide, seen } = await placedLooks(tab, read);
  const particles = ((await tab.evaluate('systems.length')) as number) > 0;
  if (wide.length === 0 && !particles) return ['nothing that moves is drawn'];
  return [
    ...(wide.length > 0 ? wrongShapes(narrow, wide, seen) : []),
    ...(particles ? await wrongParticles(tab, read) : []),
  ];
}
