import type { CollidableNode } from './collidable.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Collider } from '../../dynamics/pairs.js';
import { Members, type MemberList } from './members.js';
import { description } from '../node/common-fields.js';
import { contacts } from '../../effects/effect/chunks.js';
import { PhysicsNode } from '../node/node.js';
import { defineNode } from '../node/define.js';

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
    this.#members = new Members(this.asked<MemberList>('collidables'));
  }

  /** A parameter changed: contacts read it from the next step on. */
  updateParameters(): void {
    this.#parameters = undefined;
    contacts.code.reportTokens(this, contacts.code.unknownTokens(this), 'appliedParameters');
    contacts.code.reportSoftness(this, this.parameters.softness);
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
    return (this.#parameters ??= contacts.code.contactParameters(this, 'slipFactors'));
  }
}

const parameters = (collection: CollisionCollectionNode): void => collection.updateParameters();

export const collisionCollection = defineNode<CollisionCollectionNode>({
  name: 'CollisionCollection',
  containerField: 'collider',
  clause: '37.4.4',
  doc: 'Collidables tested against each other, with the parameters of their contacts.',
  rank: 4,
  chunk: contacts,
  bounded: true,
  make: (context) => new CollisionCollectionNode(context),
  fields: {
    ...description,
    collidables: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      nodes: ['CollidableShape', 'CollidableOffset', 'CollisionSpace'],
      takesAll: true,
      edit: 'live',
      patch: (collection) => collection.updateMembers(),
      doc: 'The members; `*` means every collidable of the world.',
    },
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: (collection) => collection.world.pairs.refresh(),
      doc: 'FALSE: its pairs are not tested.',
    },
    appliedParameters: {
      type: 'MFString',
      access: 'inputOutput',
      default: ['BOUNCE'],
      edit: 'live',
      patch: parameters,
      doc: 'Which parameters act: BOUNCE, FRICTION_COEFFICIENT-2, SPEED-1, SPEED-2, SLIP-1, SLIP-2, ERROR_REDUCTION, CONSTANT_FORCE; hyphen or underscore. USER_FRICTION means something on a Contact only.',
    },
    bounce: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, 1],
      edit: 'live',
      patch: parameters,
      doc: 'Share of the approach speed that comes back.',
    },
    minBounceSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.1,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: parameters,
      doc: 'Approach speed below which nothing bounces, m/s.',
    },
    frictionCoefficients: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      range: [0, Infinity],
      implied: true,
      edit: 'live',
      patch: parameters,
      doc: 'Coulomb friction along direction 1 and 2; without FRICTION_COEFFICIENT-2 the first acts in both. Not authored: 0.5. Direction 1 is the world’s x axis laid into the surface (z where the surface faces along x), direction 2 is across: z on a floor. Two different ones act each along its own direction, so that sliding obliquely meets both.',
    },
    surfaceSpeed: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      dimension: { length: 1 },
      edit: 'live',
      patch: parameters,
      doc: 'Speed at which the surface carries bodies along friction direction 1 and 2, m/s (a conveyor belt); needs SPEED-1, SPEED-2. What does not move is the belt; of two bodies that move, the one made earlier.',
    },
    slipFactors: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      dimension: { length: 1, force: -1 },
      edit: 'live',
      patch: parameters,
      doc: 'Sliding speed per tangential force along friction direction 1 and 2, (m/s)/N; needs SLIP-1, SLIP-2. Below 0 counts as 0.',
    },
    softnessConstantForceMix: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.0001,
      range: [0, 1],
      edit: 'live',
      patch: parameters,
      doc: 'Softness of contacts, (m/s)/N; needs CONSTANT_FORCE. A load F sinks in by F · softness / (60 · error correction). No more than a quarter of the thinner body, so that nothing falls through. It yields but does not spring back.',
    },
    softnessErrorCorrection: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.8,
      range: [0, 1],
      edit: 'live',
      patch: parameters,
      doc: 'Share of an overlap repaired per 1/60 s; needs ERROR_REDUCTION.',
    },
  },
});
