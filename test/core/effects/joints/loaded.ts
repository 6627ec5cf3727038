import { addBody, box, sphere, world, type Body, type Joint, type Vec3 } from '../../helpers.js';
import type { LevelName } from '../../../../physics-core/inside.js';

// Nets, bridges and chains that something falls on.

export interface Loaded {
  load: Body;
  joints: Joint[];
}

type World = Awaited<ReturnType<typeof world>>;

const join = (
  w: World,
  into: Joint[],
  type: 'BallJoint' | 'SingleAxisHingeJoint',
  body1: Body,
  body2: Body | undefined,
  anchorPoint: Vec3,
): void => {
  const axis = type === 'SingleAxisHingeJoint' && { axis: [0, 0, 1] };
  into.push(w.add(type, { body1, ...(body2 && { body2 }), anchorPoint, ...axis }) as Joint);
};

interface Net {
  size: number;
  /** Kilograms of a knot. */
  knot: number;
  held: (i: number, k: number) => boolean;
  load: { mass: number; size: number; drop: number };
}

/** Metres between knots, and the height of the net. */
const LINK = 0.3;
const NET = 2.2;

/** Balls, each joined to its neighbours half-way. */
export async function addNet(accuracy: LevelName, { size, knot, held, load }: Net) {
  const w = await world({ accuracy });
  const joints: Joint[] = [];
  const knots = new Map<string, Body>();
  for (let i = 0; i < size; i++)
    for (let k = 0; k < size; k++) {
      const [x, z] = [(i - (size - 1) / 2) * LINK, (k - (size - 1) / 2) * LINK];
      const geometry = [sphere(0.06)];
      const body = addBody(w, { mass: knot, position: [x, NET, z], geometry });
      knots.set(`${i} ${k}`, body);
      const [west, north] = [knots.get(`${i - 1} ${k}`), knots.get(`${i} ${k - 1}`)];
      if (west) join(w, joints, 'BallJoint', body, west, [x - LINK / 2, NET, z]);
      if (north) join(w, joints, 'BallJoint', body, north, [x, NET, z - LINK / 2]);
      if (held(i, k)) join(w, joints, 'BallJoint', body, undefined, [x, NET, z]);
    }
  const falls = addBody(w, {
    mass: load.mass,
    position: [0.02, NET + 0.06 + load.drop + load.size / 2, 0.03],
    geometry: [box(load.size, load.size, load.size)],
  });
  return { w, joints, load: falls };
}

interface Row {
  links: number;
  /** Share of its length that its ends are apart: 1 is straight. */
  span: number;
  link: { mass: number; size: Vec3 };
  type: 'BallJoint' | 'SingleAxisHingeJoint';
  load: { mass: number; size: number; drop: number };
}

const HEIGHT = 3;

/** Links in a row between two ends, a V where it has slack. */
export async function addRow(
  accuracy: LevelName,
  { links, span, link, type, load }: Row,
): Promise<Loaded & { w: World; lowest: number }> {
  const w = await world({ accuracy });
  const half = (links * LINK) / 2;
  const sag = half * Math.sqrt(1 - span * span);
  const joints: Joint[] = [];
  const at = (n: number): [number, number] => {
    const along = n * LINK - half;
    return [along * span, HEIGHT - (1 - Math.abs(along) / half) * sag];
  };
  let last: Body | undefined;
  for (let n = 0; n < links; n++) {
    const [[x0, y0], [x1, y1]] = [at(n), at(n + 1)];
    const body = addBody(w, {
      mass: link.mass,
      position: [(x0 + x1) / 2, (y0 + y1) / 2, 0],
      orientation: [0, 0, 1, Math.atan2(y1 - y0, x1 - x0)],
      geometry: [box(...link.size)],
    });
    join(w, joints, type, body, last, [x0, y0, 0]);
    if (n === links - 1) join(w, joints, type, body, undefined, [x1, y1, 0]);
    last = body;
  }
  const lowest = HEIGHT - sag;
  const falls = addBody(w, {
    mass: load.mass,
    position: [0.05, lowest + link.size[1] / 2 + load.drop + load.size / 2, 0],
    geometry: [box(load.size, load.size, load.size)],
  });
  return { w, joints, load: falls, lowest };
}
