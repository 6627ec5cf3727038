import type { Mesh } from '../../shapes/geometry.js';
import { between } from '../../solver/deformables/between.js';
import { Lattice } from '../../solver/deformables/lattice.js';
import type { Material } from '../../solver/deformables/material.js';
import { Shell } from '../../solver/deformables/shell.js';
import { DeformableNode } from './deformable-node.js';

/** kg/m³: of rubber, where nobody says how thick a skin is. */
const RUBBER = 1000;

/** Along the longest side of what is solid. */
const CELLS = 8;

/** Points by which it touches, at most, beside those of its author. */
const MOST_MORE = 2000;

/** A solid, or a hollow one. */
export class SoftBodyNode extends DeformableNode {
  protected readonly stiffest = 'youngsModulus';
  protected readonly radius = 0;

  protected whyNot({ index }: Mesh): string | undefined {
    return index.length < 12 ? 'takes a closed surface of four triangles at least' : undefined;
  }

  get #isHollow(): boolean {
    return this.asked<number>('pressure') > 0;
  }

  get #elasticity(): { youngsModulus: number; poissonsRatio: number } {
    return {
      youngsModulus: this.asked('youngsModulus'),
      poissonsRatio: this.asked('poissonsRatio'),
    };
  }

  lay(): Material {
    const { points, index } = this.mesh;
    const mass = this.asked<number>('mass');
    if (!this.#isHollow) return this.#told(this.#solid(points, index, mass));
    const pressure = this.asked<number>('pressure');
    const thickness = this.#thickness;
    return this.#told(new Shell(points, index, { mass, thickness, pressure, ...this.#elasticity }));
  }

  /** Of a skin, metres. */
  get #thickness(): number {
    return (
      this.asked<number>('thickness') || this.asked<number>('mass') / (RUBBER * areaOf(this.mesh))
    );
  }

  /** It touches by more points than its author gave it: as many as there are cells under its surface. */
  #solid(points: number[], index: number[], mass: number): Lattice {
    const more = between(points, index, sideOf(points) / CELLS, MOST_MORE);
    const lattice = new Lattice([...points, ...more], index, {
      mass,
      resolution: CELLS,
      ...this.#elasticity,
    });
    lattice.surface.shown = Math.min(lattice.surface.count, points.length / 3);
    return lattice;
  }

  #told<M extends Material>(material: M): M {
    const isNone = material.masses.count === 0;
    this.reportWhile(isNone, {
      code: 'bad-value',
      severity: 'warning',
      attribute: 'geometry',
      used: 'nothing',
      message: `${this.label}: its surface encloses nothing: it is not there`,
    });
    return material;
  }

  /** A skin is laid anew where it becomes a solid, or the other way round. */
  read(material: Material): boolean {
    if (this.#isHollow !== material instanceof Shell) return false;
    material.masses.weigh(this.asked('mass'));
    if (material instanceof Lattice) material.stiffen(this.#elasticity);
    if (material instanceof Shell) {
      material.stiffen({ ...this.#elasticity, thickness: this.#thickness });
      material.pressure = this.asked('pressure');
    }
    return true;
  }
}

/** The longest of a box around points, metres. */
function sideOf(points: readonly number[]): number {
  let most = 0;
  for (let k = 0; k < 3; k++) {
    let low = Infinity;
    let high = -Infinity;
    for (let j = k; j < points.length; j += 3) {
      low = Math.min(low, points[j]!);
      high = Math.max(high, points[j]!);
    }
    most = Math.max(most, high - low);
  }
  return most;
}

function areaOf({ points, index }: Mesh): number {
  let sum = 0;
  for (let n = 0; n + 2 < index.length; n += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * index[n + k]!) as [number, number, number];
    const way = (p: number, k: number): number => points[p + k]! - points[a + k]!;
    const x = way(b, 1) * way(c, 2) - way(b, 2) * way(c, 1);
    const y = way(b, 2) * way(c, 0) - way(b, 0) * way(c, 2);
    const z = way(b, 0) * way(c, 1) - way(b, 1) * way(c, 0);
    const area = Math.sqrt(x * x + y * y + z * z) / 2;
    if (area > 0) sum += area;
  }
  return sum;
}
