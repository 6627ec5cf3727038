import { ropes } from '../../effects/soft/effects.js';
import type { Tie } from '../../effects/soft/settings.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../body/body.js';
import { PhysicsNode } from '../node/node.js';
import type { RopeNode } from './rope-node.js';

/** What was removed, or can't be made, holds nothing. */
const standing = <N extends PhysicsNode>(node: N | null): N | undefined =>
  node?.built ? node : undefined;

/** Ties a point of a rope to a body, or to the world. */
export class AttachmentNode extends PhysicsNode implements Tie {
  #softBody: RopeNode | null = null;
  #tied: BodyNode | null = null;
  #index = 0;
  #position: Vec3 = [0, 0, 0];

  get rope(): RopeNode | undefined {
    return standing(this.#softBody);
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
    const effect = this.world.registry.find(ropes);
    effect?.tieChanged(this);
    this.#tied?.ties.delete(this);
    this.#tied = this.asked('body');
    this.#softBody = this.asked('softBody');
    this.#index = this.asked('index');
    this.#position = this.asked('position');
    this.#tied?.ties.add(this);
    this.#tellBeyond();
    effect?.tieChanged(this);
  }

  #tellBeyond(): void {
    const points = (this.rope?.places?.length ?? Infinity) / 3;
    this.reportWhile(this.index >= points, {
      code: 'out-of-range',
      severity: 'warning',
      attribute: 'index',
      value: this.index,
      used: 'nothing',
      message: `${this.label}: index ${this.index} is no point of its rope, which has ${points}, counted from 0: it holds nothing`,
    });
  }

  protected override create(): boolean {
    this.world.registry.get(ropes).tie(this);
    return true;
  }

  protected override destroy(): void {
    this.#tied?.ties.delete(this);
    this.#tied = null;
    this.world.registry.find(ropes)?.untie(this);
  }
}
