import { add, compose, invert, rotate, type Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { BodySilhouette } from '../../dynamics/body-silhouette.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Vec3 } from '../../fields/types.js';
import { SEEN, type Flat } from '../../shapes/silhouette/silhouette.js';
import { skinOf } from '../../shapes/skin/of-outline.js';
import { CutBody } from './cut-body.js';
import { Skin } from './skin.js';

/** What water asks of a body's shape, in the frame of its centre of mass. */
export class BodyInWater {
  readonly #of: readonly CollidablePart[];
  readonly #centre: Pose;
  readonly cut: CutBody;
  readonly skin: Skin;
  /** What is round shows exactly this; its skin of triangles shows a little more or less. */
  readonly #silhouette: BodySilhouette | undefined;

  constructor(body: Body) {
    const { solidParts, centerOfMass } = body;
    const intoFrame = invert(centerOfMass);
    this.#of = solidParts;
    this.#centre = centerOfMass;
    this.cut = new CutBody(solidParts, intoFrame);
    this.skin = new Skin(solidParts.flatMap((part) => trianglesOf(part, intoFrame)));
    if (solidParts.some(isRound)) this.#silhouette = new BodySilhouette(body);
  }

  /** By how much more of the body than of its skin is seen along a unit vector, as a factor. */
  evenness(way: Flat): number {
    if (!this.#silhouette) return 1;
    this.#silhouette.along(way, seen);
    const shown = this.skin.seenAlong(way);
    return shown > 0 ? seen[0]! / shown : 1;
  }

  /** Whether it is that of the body as it is now. */
  isOf({ solidParts, centerOfMass }: Body): boolean {
    return this.#of === solidParts && this.#centre === centerOfMass;
  }
}

const seen = new Float64Array(SEEN);

const ROUND = ['ball', 'frustum', 'ellipsoid'];

const isRound = ({ outline }: CollidablePart): boolean => ROUND.includes(outline?.kind ?? '');

function trianglesOf({ outline, pose }: CollidablePart, intoFrame: Pose): number[] {
  if (!outline) return [];
  const { p, q } = compose(intoFrame, pose);
  const triangles = skinOf(outline);
  const placed: number[] = [];
  for (let i = 0; i < triangles.length; i += 3)
    placed.push(...add(p, rotate(q, triangles.slice(i, i + 3) as Vec3)));
  return placed;
}
