import type { DeformableSettings } from '../../effects/deformables/settings.js';
import type { Vec3 } from '../../fields/types.js';
import type { Mesh } from '../../shapes/geometry.js';
import { Cloth } from '../../solver/deformables/cloth.js';
import { DeformableNode } from './deformable-node.js';
import { sheet } from './sheet.js';

/** A sheet of threads. */
export class ClothNode extends DeformableNode {
  protected readonly stiffest = 'bendStiffness';

  override get mesh(): Mesh {
    const [width, height] = this.asked<[number, number]>('size');
    if (!(width > 0 && height > 0)) return super.mesh;
    return sheet(width, height, this.asked<[number, number]>('subdivision'));
  }

  protected get radius(): number {
    return this.asked<number>('thickness') / 2;
  }

  override get settings(): DeformableSettings {
    const wind = this.asked<Vec3>('wind');
    return {
      ...super.settings,
      touches: this.radius > 0,
      wind: wind.some((v) => v !== 0) ? wind : undefined,
      selfCollision: this.asked('selfCollision'),
    };
  }

  protected whyNot({ index }: Mesh): string | undefined {
    return index.length < 3 ? 'takes a surface of one triangle at least, and has none' : undefined;
  }

  lay(): Cloth {
    const { points, index } = this.mesh;
    const cloth = new Cloth(points, index, this.asked('mass'));
    this.read(cloth);
    return cloth;
  }

  read(cloth: Cloth): boolean {
    cloth.say({
      mass: this.asked('mass'),
      stretch: this.asked('stretchStiffness'),
      shear: this.asked('shearStiffness'),
      bend: this.asked('bendStiffness'),
      tear: this.asked('tearStrain'),
    });
    return true;
  }
}
