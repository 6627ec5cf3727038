import { ParticleSystemNode } from '../../../physics-core/particles.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { nodeOf, type X3DNode } from '../x3dom/x3dom.js';
import { CloudShape, type Look } from './cloud-shape.js';
import { frameOf } from './frame.js';
import { partOf } from './plan-part.js';

/** The systems of each world that are drawn. */
const drawings = new WeakMap<PageWorld, Set<CloudDrawing>>();
const ofSystem = new WeakMap<Binding, CloudDrawing>();

/** Has a system drawn as long as it has a node. */
export function drawSystem(system: Binding): void {
  if (ofSystem.has(system)) return;
  const drawing = new CloudDrawing(system);
  ofSystem.set(system, drawing);
  system.onnode = () => drawing.nodeChanged();
}

function drawingsIn(world: PageWorld): Set<CloudDrawing> {
  const known = drawings.get(world);
  if (known) return known;
  const all = new Set<CloudDrawing>();
  drawings.set(world, all);
  world.onshow = () => {
    for (const each of all) each.draw();
  };
  return all;
}

const nodeNamed = (system: Binding, name: string, tag: RegExp): X3DNode | undefined => {
  const element = partOf(system, name, tag);
  return element && nodeOf(element);
};

/** One ParticleSystem as x3dom draws it. */
class CloudDrawing {
  readonly #system: Binding;
  #world: PageWorld | null = null;
  #shape: CloudShape | undefined;
  #look: Look | undefined;

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
    this.#look = undefined;
    if (!at) this.#remove();
  }

  #remove(): void {
    this.#shape?.remove();
    this.#shape = undefined;
  }

  draw(): void {
    const { node, world, units } = this.#system;
    if (!(node instanceof ParticleSystemNode) || !world) return;
    const shape = this.#shapeNow();
    const shown = shape && node.shown;
    if (!shown) return;
    const since = (1 - world.poses.fraction) * world.timeStep;
    shape.show({ ...shown, since, length: units.length, origin: world.poses.origin });
  }

  /** A shape of the present look: made anew where what it is made of is another. */
  #shapeNow(): CloudShape | undefined {
    const look = this.#look ?? this.#readLook();
    if (!look) return undefined;
    if (!this.#shape?.looks(look)) {
      this.#remove();
      this.#shape = new CloudShape(look);
    }
    this.#look = look;
    return this.#shape;
  }

  #readLook(): Look | undefined {
    const system = this.#system;
    const doc = nodeOf(system.element)?._nameSpace?.doc;
    if (!doc?._scene) return undefined;
    const { body, matrix } = frameOf(system);
    return {
      doc,
      element: system.element,
      type: String(system.get('geometryType')),
      size: system.node!.get('particleSize') as [number, number],
      axes: body ? undefined : matrix,
      appearance: nodeNamed(system, 'appearance', /^appearance$/),
      geometry: nodeNamed(system, 'geometry', GEOMETRY),
      color: nodeNamed(system, 'color', /^color(rgba)?$/),
      colorKey: system.get('colorKey') as number[],
      texCoord: nodeNamed(system, 'texCoord', /^texturecoordinate$/),
      texCoordKey: system.get('texCoordKey') as number[],
    };
  }
}

/** What is none of the other children that a system may have. */
const GEOMETRY =
  /^(?!.*(emitter|model|appearance|color|colorrgba|texturecoordinate.*|rigid-?body)$)(?!metadata)/;
