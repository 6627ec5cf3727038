import type { Mesh } from '../../shapes/geometry.js';
import type { Material } from '../../solver/deformables/material.js';
import { DeformableNode } from './deformable-node.js';

/** A solid, or a hollow one. */
export class SoftBodyNode extends DeformableNode {
  protected readonly stiffest = 'youngsModulus';
  protected readonly radius = 0;

  protected whyNot({ index }: Mesh): string | undefined {
    return index.length < 12 ? 'takes a closed surface of four triangles at least' : undefined;
  }

  lay(): Material {
    throw new Error('not yet');
  }

  read(_material: Material): void {}
}
