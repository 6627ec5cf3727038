import { Bounds } from '../../matter/bounds.js';
import { isHidden } from '../../matter/hidden.js';
import { OwnShape } from '../../matter/own-shape.js';
import type { X3DNode } from '../../x3dom/x3dom.js';
import type { SurfaceData } from './surface-data.js';
import { Skin } from './skin.js';
import { isOutward } from './outward.js';
import { textureOn } from './texture-on.js';

/** Where a surface is, metres: as the last step left it, and how fast that went there. */
export interface ShownSurface {
  places: Float64Array;
  velocities: Float64Array;
  /** Three points each; another list where it has torn, or was laid anew. */
  triangles: Int32Array;
  /** Another number whenever it is elsewhere. */
  moves: number;
  /** Seconds before the end of that step: then it is shown. */
  since: number;
}

/** How it looks. */
export interface Look {
  /** Its points as it is laid, which say what belongs together. */
  laid: () => ArrayLike<number>;
  /** In its own frame; `said` is another object when its author said something else. */
  said: SurfaceData | undefined;
  surface: () => SurfaceData | undefined;
  /** It is seen from outside alone. */
  isSolid: boolean;
}

/** A cloth or a soft body, drawn instead of its author's Shape. */
export class SurfaceShape extends OwnShape {
  readonly #soft: Element;
  readonly #bounds: Bounds;
  #skin: Skin | undefined;
  #triangles: Int32Array | undefined;
  #said: SurfaceData | undefined;
  #unit = 0;
  #points = new Float64Array(0);
  #moves = -1;
  #since = -1;

  constructor(soft: Element, instead: X3DNode, appearance: X3DNode) {
    super(instead, appearance, 'IndexedTriangleSet');
    this.#soft = soft;
    this.#bounds = new Bounds(this.shape);
  }

  /** A Shape in it stands in nothing that x3dom draws: the cloth or the soft body does. */
  protected override get hidden(): boolean {
    return super.hidden || isHidden(this.#soft);
  }

  /** `unit`: metres of one unit of what x3dom draws. */
  show(shown: ShownSurface, look: Look, unit: number): void {
    const { places, velocities, triangles, moves, since } = shown;
    const isOther =
      this.#triangles !== triangles ||
      this.#said !== look.said ||
      this.#points.length !== places.length ||
      this.#unit !== unit;
    if (!isOther && this.#moves === moves && this.#since === since) return;
    this.#moves = moves;
    this.#since = since;
    if (isOther) this.#wear(shown, look, unit);
    const points = this.#points;
    for (let i = 0; i < points.length; i++)
      points[i] = (places[i]! - since * velocities[i]!) / unit;
    const skin = this.#skin!;
    skin.write(points);
    this.#bounds.around(points, 0);
    this.upload('POSITION', skin.positions);
    this.upload('NORMAL', skin.normals);
    this.draw();
  }

  #wear(
    { places, triangles }: ShownSurface,
    { laid, said, surface, isSolid }: Look,
    unit: number,
  ): void {
    this.#triangles = triangles;
    this.#said = said;
    this.#unit = unit;
    this.#points = new Float64Array(places.length);
    const points = laid();
    const skin = new Skin(points, triangles, textureOn(points, triangles, surface()));
    this.#skin = skin;
    this.mesh._positions[0] = skin.positions;
    this.mesh._normals[0] = skin.normals;
    this.mesh._texCoords[0] = skin.texCoords;
    this.mesh._indices[0] = skin.index;
    // Of what is seen from both sides x3dom turns normals round that look away: near its rim a solid would be dark.
    this.shape._cf.geometry!.node!._vf.solid = isSolid && isOutward(points, triangles);
    this.remake();
  }
}
