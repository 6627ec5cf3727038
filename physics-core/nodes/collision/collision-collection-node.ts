import type { CollidableNode } from './collidable.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Collider } from '../../dynamics/pairs.js';
import { Members, type MemberList } from './members.js';
import {
  reportIdle,
  reportSoftness,
  reportTokens,
} from '../../effects/contacts/collection-reports.js';
import { contactParameters, unknownTokens } from '../../effects/contacts/parameters.js';
import { PhysicsNode } from '../node/node.js';

/** What is written for somebody. */
const SPEAKS = ['bounce', 'frictionCoefficients', 'surfaceSpeed', 'slipFactors'];

/** Which collidables are tested against each other, and what their contacts are like. */
export class CollisionCollectionNode extends PhysicsNode implements Collider {
  #members = new Members();
  #parameters: ContactParameters | undefined;

  protected override create(): boolean {
    this.#readMembers();
    this.world.pairs.addCollection(this);
    return true;
  }

  protected override destroy(): void {
    this.world.pairs.removeCollection(this);
  }

  lists(collidable: CollidableNode): boolean {
    return this.#members.has(collidable);
  }

  updateMembers(): void {
    this.#readMembers();
    this.world.pairs.refresh();
  }

  #readMembers(): void {
    const list = this.asked<MemberList>('collidables');
    this.#members = new Members(list);
    reportIdle(this, list.length === 0 && SPEAKS.some((field) => this.authored(field)));
  }

  /** A parameter changed: contacts read it from the next step on. */
  updateParameters(): void {
    this.#parameters = undefined;
    reportTokens(this, unknownTokens(this), 'appliedParameters');
    reportSoftness(this, this.parameters.softness);
    for (const body of this.world.bodies) {
      this.world.pairs.contactsChanged(body);
      // What lay still may slide now.
      if (body.parts.some(({ collidable }) => this.#members.has(collidable))) body.wake();
    }
    this.world.pairs.parametersChanged();
  }

  get enabled(): boolean {
    return this.asked('enabled');
  }

  get parameters(): ContactParameters {
    return (this.#parameters ??= contactParameters(this, 'slipFactors'));
  }
}
