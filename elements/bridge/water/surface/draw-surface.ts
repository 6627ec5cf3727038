// The chunk `surface`: draws water whose surface moves.
import { WaterVolumeNode } from '../../../../physics-core/water.js';
import { matrixOf } from '../../geometry/matrix.js';
import type { Binding } from '../../nodes/binding.js';
import type { PageWorld } from '../../nodes/surroundings.js';
import { nodeOf, type X3DNode } from '../../x3dom/x3dom.js';
import { SurfaceShape } from './surface-shape.js';
import type { Surfaces } from './surfaces.js';

const ofWater = new WeakMap<Binding, SurfaceDrawing>();
const drawings = new WeakMap<PageWorld, Set<SurfaceDrawing>>();

function drawingsIn(world: PageWorld): Set<SurfaceDrawing> {
  const known = drawings.get(world);
  if (known) return known;
  const all = new Set<SurfaceDrawing>();
  drawings.set(world, all);
  const { onshow } = world;
  world.onshow = () => {
    onshow?.();
    for (const each of all) each.draw();
  };
  return all;
}

/** One WaterVolume as x3dom draws it. */
class SurfaceDrawing {
  readonly #water: Binding;
  #shapes: readonly Element[] = [];
  #world: PageWorld | null = null;
  #shape: SurfaceShape | undefined;

  constructor(water: Binding) {
    this.#water = water;
  }

  /** Its node was made, patched, moved, or went; these Shapes are what is seen of it. */
  changed(shapes: readonly Element[]): void {
    const { node, world } = this.#water;
    this.#shapes = shapes;
    const at = node ? world : null;
    if (at !== this.#world) {
      if (this.#world) drawingsIn(this.#world).delete(this);
      if (at) drawingsIn(at).add(this);
      this.#world = at;
    }
    if (at) at.work();
    else this.#remove();
  }

  #remove(): void {
    const shape = this.#shape;
    this.#shape = undefined;
    shape?.remove();
  }

  draw(): void {
    const { node, units } = this.#water;
    const shown = node instanceof WaterVolumeNode ? node.surface : undefined;
    const drawn = shown && this.#shapeNow();
    if (!drawn) return this.#remove();
    const { pose, size } = (node as WaterVolumeNode).settings;
    const m = matrixOf({ position: [...pose.p], quaternion: [...pose.q] });
    drawn.show(shown, {
      axes: [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]],
      middle: pose.p,
      depth: size[1],
      unit: units.length,
    });
  }

  /** Of the first of its Shapes that x3dom has whole. */
  #shapeNow(): SurfaceShape | undefined {
    for (const element of this.#shapes) {
      const shape: X3DNode | undefined = nodeOf(element);
      const appearance = shape?._cf.appearance?.node;
      if (!shape || !appearance || !shape._nameSpace?.doc._scene) continue;
      if (this.#shape?.wears(shape, appearance)) return this.#shape;
      this.#remove();
      return (this.#shape = new SurfaceShape(shape, appearance));
    }
    return undefined;
  }
}

export const provide = (): Surfaces => ({
  show(water, shapes) {
    const known = ofWater.get(water) ?? new SurfaceDrawing(water);
    ofWater.set(water, known);
    known.changed(shapes);
  },
});
