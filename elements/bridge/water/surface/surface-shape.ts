import type { ShownSurface } from '../../../../physics-core/water.js';
import { OwnShape } from '../../matter/own-shape.js';
import { x3dom, type X3DNode } from '../../x3dom/x3dom.js';
import { SurfaceMesh, type Place } from './mesh.js';

/** The surface of a volume, drawn instead of its author's Shape. */
export class SurfaceShape extends OwnShape {
  #written: SurfaceMesh | undefined;
  #cells = 0;
  #version = -1;
  #place = '';

  constructor(instead: X3DNode, appearance: X3DNode) {
    super(instead, appearance, 'IndexedTriangleSet');
    // It is as large as the author's, but for its waves.
    const volume = new (x3dom()!.fields.BoxVolume)();
    this.shape.getVolume = () => volume;
  }

  show(shown: ShownSurface, place: Place): void {
    const where = `${place.axes.join()} ${place.middle.join()} ${place.depth} ${place.unit}`;
    if (this.#version === shown.version && this.#place === where) return;
    this.#version = shown.version;
    this.#place = where;
    const cells = shown.columns * 1024 + shown.rows;
    if (cells !== this.#cells) this.#grow(shown);
    this.#cells = cells;
    const written = this.#written!;
    written.write(shown, place);
    this.upload('POSITION', written.positions);
    this.upload('NORMAL', written.normals);
    this.draw();
  }

  #grow(shown: ShownSurface): void {
    const written = new SurfaceMesh(shown);
    this.#written = written;
    this.mesh._positions[0] = written.positions;
    this.mesh._normals[0] = written.normals;
    this.mesh._texCoords[0] = written.texCoords;
    this.mesh._indices[0] = written.index;
    this.remake();
  }
}
