import { ParticleSystemNode } from '../../../physics-core/particles.js';
import { identity, type Affine } from '../geometry/matrix.js';
import { drawingsIn } from '../matter/drawings.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { nodeOf, type X3DDocument, type X3DNode } from '../x3dom/x3dom.js';
import { CloudShape } from './cloud-shape.js';
import { frameOf } from './frame.js';
import type { Look } from './look.js';
import { APPEARANCE, COLOR, GEOMETRY, partOf, TEX_COORD } from './parts.js';
import type { Color, Point } from './ramp.js';

const ofSystem = new WeakMap<Binding, CloudDrawing>();

/** What draws a system: to be told when its node changes. */
export function drawingOf(system: Binding): { nodeChanged(): void } {
  const known = ofSystem.get(system) ?? new CloudDrawing(system);
  ofSystem.set(system, known);
  return known;
}

const nodeIn = (element: Element | undefined): X3DNode | undefined => element && nodeOf(element);

/** The elements that a system is drawn with. */
const partsOf = (system: Binding) => ({
  appearance: partOf(system, 'appearance', APPEARANCE),
  geometry: partOf(system, 'geometry', GEOMETRY),
  color: partOf(system, 'color', COLOR),
  texCoord: partOf(system, 'texCoord', TEX_COORD),
});

/** One ParticleSystem as x3dom draws it. */
class CloudDrawing {
  readonly #system: Binding;
  #world: PageWorld | null = null;
  #shape: CloudShape | undefined;
  #frame: Affine = identity();
  #parts: Partial<ReturnType<typeof partsOf>> = {};
  /** Read anew in each frame: nothing is made for that. */
  readonly #look = {} as Look;

  constructor(system: Binding) {
    this.#system = system;
  }

  /** Its node was made, patched, moved, or went. */
  nodeChanged(): void {
    const { node, world } = this.#system;
    const at = node ? world : null;
    if (at !== this.#world) {
      if (this.#world) drawingsIn(this.#world).delete(this);
      if (at) drawingsIn(at).add(this);
      this.#world = at;
    }
    if (!at) return this.#remove();
    this.#frame = frameOf(this.#system).matrix;
    this.#parts = partsOf(this.#system);
    // It may look otherwise now, in a world that stands, too.
    at.work();
  }

  #remove(): void {
    const shape = this.#shape;
    this.#shape = undefined;
    shape?.remove();
  }

  draw(): void {
    const { node, world } = this.#system;
    if (!(node instanceof ParticleSystemNode) || !world) return;
    const shape = this.#shapeNow(node);
    const shown = shape && node.shown;
    if (shown) shape.show(shown, (1 - world.poses.fraction) * world.timeStep);
  }

  /** A shape of the present look: made anew where what it is made of is another. */
  #shapeNow(node: ParticleSystemNode): CloudShape | undefined {
    const doc = nodeOf(this.#system.element)?._nameSpace?.doc;
    if (!doc?._scene) return undefined;
    this.#readLook(node, doc);
    if (!this.#shape?.wears(this.#look)) {
      this.#remove();
      this.#shape = new CloudShape(this.#look);
    }
    return this.#shape;
  }

  #readLook(node: ParticleSystemNode, doc: X3DDocument): void {
    const look = this.#look;
    const geometry = nodeIn(this.#parts.geometry)?._mesh;
    look.doc = doc;
    look.element = this.#system.element;
    look.type = node.asked('geometryType');
    look.size = node.asked('particleSize');
    look.frame = this.#frame;
    look.length = this.#system.units.length;
    look.appearance = nodeIn(this.#parts.appearance);
    // Lists that x3dom makes anew with each edit, as the node does those of its keys.
    look.geometry = geometry;
    look.points = geometry?._positions[0];
    look.colors = nodeIn(this.#parts.color)?._vf.color as Iterable<Color> | undefined;
    look.colorKey = node.asked('colorKey');
    look.texCoords = nodeIn(this.#parts.texCoord)?._vf.point as Iterable<Point> | undefined;
    look.texCoordKey = node.asked('texCoordKey');
  }
}
