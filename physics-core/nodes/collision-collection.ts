import type { Vec2 } from '../fields/types.js';
import { DEFAULT_FRICTION } from '../world/pairs.js';
import type { CollidableNode } from './collidable.js';
import { PhysicsNode } from './node.js';
import { defineNode } from './table.js';

/** What the solver is told about a touching pair. */
export interface ContactParameters {
  bounce: number;
  minBounceSpeed: number;
  friction: number;
}

/** Both spellings stand in real files: schema and examples print hyphens, the 4.0 prose underscores. */
const normal = (token: string): string => token.toUpperCase().replace(/[-_](?=[12]$)/, '_');

/** Which collidables are tested against each other, and what their contacts are like. */
export class CollisionCollectionNode extends PhysicsNode {
  #members = new Set<CollidableNode>();
  #parameters: ContactParameters | undefined;

  protected override create(): boolean {
    this.world.pairs.add(this);
    return true;
  }

  protected override destroy(): void {
    this.world.pairs.remove(this);
  }

  lists(collidable: CollidableNode): boolean {
    return this.asked('collidables') === '*' || this.#members.has(collidable);
  }

  updateMembers(): void {
    const list = this.asked<'*' | CollidableNode[]>('collidables');
    this.#members = new Set(list === '*' ? [] : list);
    this.world.pairs.refresh();
  }

  /** A parameter changed: contacts read it from the next step on. */
  updateParameters(): void {
    this.#parameters = undefined;
    for (const body of this.world.bodies) if (body.built) this.world.contactParametersChanged(body);
  }

  get parameters(): ContactParameters {
    this.#parameters ??= this.#read();
    return this.#parameters;
  }

  #read(): ContactParameters {
    const applied = new Set(this.asked<string[]>('appliedParameters').map(normal));
    return {
      bounce: applied.has('BOUNCE') ? this.asked<number>('bounce') : 0,
      minBounceSpeed: this.asked<number>('minBounceSpeed'),
      friction: this.#friction(),
    };
  }

  /** Without strict rules, friction nobody wrote is the library's default and not the field's 0. */
  #friction(): number {
    const strict = this.world.settings.asked('collisionRules') === 'strict';
    const meant = strict || this.authored('frictionCoefficients');
    return meant ? this.asked<Vec2>('frictionCoefficients')[0] : DEFAULT_FRICTION;
  }
}

const parameters = (collection: CollisionCollectionNode): void => collection.updateParameters();

export const collisionCollection = defineNode<CollisionCollectionNode>({
  name: 'CollisionCollection',
  containerField: 'collider',
  clause: '37.4.4',
  doc: 'Collidables tested against each other, with the parameters of their contacts.',
  rank: 4,
  make: (context) => new CollisionCollectionNode(context),
  fields: {
    collidables: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      nodes: ['CollidableShape', 'CollidableOffset'],
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
      doc: 'Which parameters act. BOUNCE switches bounce on; the other tokens are taken in both spellings (hyphen, underscore).',
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
      edit: 'live',
      patch: parameters,
      doc: 'Coulomb friction; the first acts in both directions.',
    },
    surfaceSpeed: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      dimension: { length: 1 },
      edit: 'passive',
      unsimulated: true,
      doc: 'Speed of the surface along the friction directions, m/s (a conveyor belt).',
    },
    slipFactors: {
      type: 'SFVec2f',
      access: 'inputOutput',
      default: [0, 0],
      edit: 'passive',
      unsimulated: true,
      doc: 'Sliding speed per tangential force, (m/s)/N.',
    },
    softnessConstantForceMix: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.0001,
      range: [0, 1],
      edit: 'passive',
      unsimulated: true,
      doc: 'Softness of contacts.',
    },
    softnessErrorCorrection: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.8,
      range: [0, 1],
      edit: 'passive',
      unsimulated: true,
      doc: 'Share of an overlap repaired per step.',
    },
  },
});
