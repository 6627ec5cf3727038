import { DRAG_MODES } from '../dynamics/body.js';
import type { ContactGiver } from '../dynamics/contact.js';
import { givenContacts } from '../effects/contacts/given-contacts.js';
import { debugging } from '../effects/debug/debugging.js';
import { BodyNode } from './body/body.js';
import { unknownTokens } from './collision/contact-parameters.js';
import { cut, show, showUsed } from '../base/show.js';
import { AUTO, DEFAULT_LEVEL, levelNames } from '../dynamics/levels.js';
import type { ContactNode } from './collision/contact.js';
import { PhysicsNode } from './node/node.js';
import { defineNode } from './node/define.js';

/** Settings of a world and defaults of the bodies under it. The first collection of a world gives the settings. */
export class CollectionNode extends PhysicsNode implements ContactGiver {
  #taken: ContactNode[] | undefined;

  get hasCollider(): boolean {
    return this.asked('collider') !== null;
  }

  configureWorld(): void {
    this.world.configure();
  }

  /** In a shared world the first collection's world-wide fields hold; what this one says otherwise is reported. */
  compareWith(first: CollectionNode): void {
    for (const [name, field] of Object.entries(this.type.fields)) {
      if (!field.worldWide) continue;
      const [asked, used] = [this.asked(name), first.asked(name)];
      this.reportWhile(this !== first && this.authored(name) && asked !== used, {
        code: 'shared-world-conflict',
        severity: 'warning',
        attribute: name,
        value: asked,
        used,
        message: `${this.label}: ${name}="${show(asked)}" differs from the first collection of the shared world; ${showUsed(used)} is used`,
      });
    }
  }

  /** Bodies read gravity and rest from their own collection. */
  eachBody(field: string): void {
    for (const node of this.world.nodes)
      if (node instanceof BodyNode && node.settings === this) node.touch(field);
  }

  updateColliders(): void {
    this.world.pairs.refresh();
  }

  /** A list acts once, and not again when the collection is made anew. */
  takeContacts(): void {
    const list = this.asked<ContactNode[]>('set_contacts');
    if (!this.authored('set_contacts') || list === this.#taken) return;
    this.#taken = list;
    this.#reportTokens(list);
    this.world.registry.get(givenContacts).give(this, list);
  }

  /** Here and not at the contacts, which last a step only. */
  #reportTokens(list: readonly ContactNode[]): void {
    const unknown = [...new Set(list.flatMap(unknownTokens))];
    if (unknown.length === 0) return;
    this.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: 'set_contacts',
      value: unknown.join(' '),
      used: 'the others',
      message: `${this.label}: the appliedParameters of a contact in set_contacts have no ${cut(unknown.join(', '))}; the others are used`,
    });
  }

  updateDebug(): void {
    this.#draw(this.asked('debug'));
  }

  #draw(on: boolean): void {
    const { registry: effects } = this.world;
    if (on) effects.get(debugging).need(this, 'debug');
    else effects.find(debugging)?.release(this);
  }

  protected override created(): void {
    this.world.configure();
  }

  protected override released(): void {
    this.#draw(false);
    this.world.configure();
    this.world.pairs.refresh();
  }
}

const configure = (collection: CollectionNode): void => collection.configureWorld();
const restOfBodies = (collection: CollectionNode): void => collection.eachBody('autoDisable');

export const rigidBodyCollection = defineNode<CollectionNode>({
  name: 'RigidBodyCollection',
  containerField: 'children',
  clause: '37.4.12',
  doc: 'A world of bodies and joints: its gravity, its solver settings and the defaults of its bodies.',
  rank: 0,
  bounded: true,
  make: (context) => new CollectionNode(context),
  fields: {
    bodies: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      edit: 'passive',
      doc: 'The bodies; membership is kept at each body.',
    },
    joints: {
      type: 'MFNode',
      access: 'inputOutput',
      default: [],
      edit: 'passive',
      doc: 'The joints; membership is kept at each joint.',
    },
    collider: {
      type: 'SFNode',
      access: 'initializeOnly',
      default: null,
      nodes: ['CollisionCollection'],
      edit: 'live',
      patch: (collection) => collection.updateColliders(),
      doc: 'Set: exactly the pairs inside that CollisionCollection collide. Not set: every pair of the world.',
    },
    set_contacts: {
      type: 'MFNode',
      access: 'inputOnly',
      default: [],
      nodes: ['Contact'],
      edit: 'live',
      patch: (collection) => collection.takeContacts(),
      doc: 'Contacts for the next step, as page code changed those of a CollisionSensor: what the list leaves out does not push, what page code added does. With a collider it only changes parameters.',
    },
    enabled: {
      type: 'SFBool',
      access: 'inputOutput',
      default: true,
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'FALSE freezes the simulation; it resumes without a jump in time.',
    },
    gravity: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, -9.8, 0],
      dimension: { length: 1 },
      edit: 'live',
      patch: (collection) => collection.eachBody('useGlobalGravity'),
      doc: 'Acceleration of every body that uses global gravity, m/s².',
    },
    preferAccuracy: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'TRUE asks for accuracy level `precise` where no level is authored.',
    },
    iterations: {
      type: 'SFInt32',
      access: 'inputOutput',
      default: 10,
      range: [0, Infinity],
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Solver iterations per step; authored, it wins over the accuracy level. 0 counts as 1.',
    },
    errorCorrection: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.8,
      range: [0, 1],
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Share of a joint error repaired per 1/60 s; authored, it wins over the accuracy level.',
    },
    constantForceMix: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.0001,
      range: [0, Infinity],
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Softness of joints, m/(N·s); acts where authored.',
    },
    contactSurfaceThickness: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Depth that resting contacts keep, metres.',
    },
    maxCorrectionSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: -1,
      range: [-1, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Greatest speed at which overlaps are pushed apart, m/s; -1 is unlimited. The push adds no velocity.',
    },
    autoDisable: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      edit: 'live',
      patch: restOfBodies,
      doc: 'Default of the bodies. Not authored: bodies at rest may sleep unnoticed. FALSE: never. TRUE: by the fields below.',
    },
    disableTime: {
      type: 'SFTime',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      edit: 'live',
      patch: restOfBodies,
      doc: 'Seconds below both speeds before a body sleeps.',
    },
    disableLinearSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { length: 1 },
      edit: 'live',
      patch: restOfBodies,
      doc: 'Speed below which a body may sleep, m/s.',
    },
    disableAngularSpeed: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, Infinity],
      dimension: { angle: 1 },
      edit: 'live',
      patch: restOfBodies,
      doc: 'Angular speed below which a body may sleep, rad/s.',
    },
    accuracy: {
      type: 'SFString',
      access: 'inputOutput',
      default: DEFAULT_LEVEL,
      values: [...levelNames, AUTO],
      own: true,
      edit: 'live',
      patch: configure,
      worldWide: true,
      doc: 'Accuracy level: game, standard (default), fine, precise, reference; auto takes the finest that fits the time budget.',
    },
    timeBudget: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 6,
      range: [0, Infinity],
      own: true,
      edit: 'passive',
      worldWide: true,
      doc: 'Milliseconds per frame that accuracy auto lets the physics take, in nine of ten frames.',
    },
    rest: {
      type: 'SFString',
      access: 'inputOutput',
      default: 'auto',
      values: ['auto', 'never'],
      own: true,
      edit: 'live',
      patch: restOfBodies,
      doc: '`never` keeps bodies awake whose autoDisable nobody wrote.',
    },
    collisionRules: {
      type: 'SFString',
      access: 'inputOutput',
      default: 'lenient',
      values: ['lenient', 'strict'],
      own: true,
      edit: 'live',
      patch: (collection) => collection.updateColliders(),
      doc: '`strict` follows the standard to the letter: without a collider nothing collides but the contacts of a CollisionSensor that page code hands to set_contacts, and friction is what frictionCoefficients say.',
    },
    dragMode: {
      type: 'SFString',
      access: 'inputOutput',
      default: 'spring',
      values: DRAG_MODES,
      own: true,
      edit: 'live',
      patch: (collection) => collection.eachBody('dragMode'),
      doc: 'How its bodies are dragged: spring (default), kinematic, teleport.',
    },
    draggableBody: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'live',
      patch: (collection) => collection.eachBody('draggableBody'),
      doc: 'TRUE: people may drag all of its bodies that move.',
    },
    runHidden: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'passive',
      doc: 'Keeps running while the page is hidden or the scene scrolled away.',
    },
    debug: {
      type: 'SFBool',
      access: 'inputOutput',
      default: false,
      own: true,
      edit: 'live',
      patch: (collection) => collection.updateDebug(),
      doc: 'Draws its world as Bullet has it: shapes (awake green, asleep blue, fixed grey, carried orange), centres of mass, joints with their limits, contacts.',
    },
    heapLimit: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 512,
      range: [16, 2048],
      own: true,
      edit: 'passive',
      worldWide: true,
      doc: 'Greatest size of the wasm heap, MB; looked at whenever something is made.',
    },
  },
});
