import { ropes } from '../../effects/soft/effects.js';
import { deformables } from '../../effects/deformables/effects.js';
import type { DeformableTie } from '../../effects/deformables/ties.js';
import type { Tie } from '../../effects/soft/settings.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../body/body.js';
import { PhysicsNode } from '../node/node.js';
import type { DeformableNode } from './deformable-node.js';
import type { RopeNode } from './rope-node.js';

/** What was removed, or can't be made, holds nothing. */
const standing = <N extends PhysicsNode>(node: N | null): N | undefined =>
  node?.built ? node : undefined;

/** Ties a point of a rope, a cloth or a soft body to a body, or to the world. */
export class AttachmentNode extends PhysicsNode implements Tie, DeformableTie {
  #softBody: RopeNode | DeformableNode | null = null;
  #tied: BodyNode | null = null;
  #index = 0;
  #position: Vec3 = [0, 0, 0];

  get #tiesTo(): RopeNode | DeformableNode | undefined {
    return standing(this.#softBody);
  }

  get rope(): RopeNode | undefined {
    const soft = this.#tiesTo;
    return soft?.tiedBy === ropes ? (soft as RopeNode) : undefined;
  }

  get soft(): DeformableNode | undefined {
    const soft = this.#tiesTo;
    return soft?.tiedBy === deformables ? (soft as DeformableNode) : undefined;
  }

  get index(): number {
    return this.#index;
  }

  get body(): BodyNode | undefined {
    const body = standing(this.#tied);
    return body?.active ? body : undefined;
  }

  get position(): Vec3 {
    return this.#position;
  }

  get holds(): boolean {
    return this.built && (this.#tied === null || this.body !== undefined);
  }

  /** What it ties together is another now. */
  changed(): void {
    this.#tellEffect();
    this.#tied?.ties.delete(this);
    this.#tied = this.asked('body');
    this.#softBody = this.asked('softBody');
    this.#index = this.asked('index');
    this.#position = this.asked('position');
    // What a rope holds the joint solve has to know of.
    if (this.#softBody?.tiedBy === ropes) this.#tied?.ties.add(this);
    this.#tellBeyond();
    this.#join();
    this.#tellEffect();
  }

  #tellEffect(): void {
    const { registry } = this.world;
    registry.find(ropes)?.tieChanged(this);
    registry.find(deformables)?.tieChanged(this);
  }

  /** Whoever it ties something of has to know it. */
  #join(): void {
    const { registry } = this.world;
    if (this.#softBody?.tiedBy === ropes) registry.get(ropes).tie(this);
    else if (this.#softBody) registry.get(deformables).tie(this);
  }

  #tellBeyond(): void {
    const points = (this.#tiesTo?.places?.length ?? Infinity) / 3;
    this.reportWhile(this.index >= points, {
      code: 'out-of-range',
      severity: 'warning',
      attribute: 'index',
      value: this.index,
      used: 'nothing',
      message: `${this.label}: index ${this.index} is no point of what it ties, which has ${points}, counted from 0: it holds nothing`,
    });
  }

  protected override create(): boolean {
    this.#softBody = this.asked('softBody');
    this.#join();
    return true;
  }

  protected override destroy(): void {
    this.#tied?.ties.delete(this);
    this.#tied = null;
    this.world.registry.find(ropes)?.untie(this);
    this.world.registry.find(deformables)?.untie(this);
  }
}
