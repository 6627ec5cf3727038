import type { EventQueue } from '../../base/event-queue.js';
import type { ProblemReport } from '../../base/problems.js';
import type { Bodies } from '../../dynamics/bodies.js';
import type { Body } from '../../dynamics/body.js';
import type { Collidable } from '../../dynamics/collidable.js';
import type { Collider, Pairs } from '../../dynamics/pairs.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Effects } from '../../effects/effect/effects.js';
import type { NodeData } from './node-data.js';
import type { PhysicsNode } from './node.js';
import type { NodeType } from './table.js';

/** What a node is born with. */
export interface NodeContext {
  world: NodeWorld;
  type: NodeType;
  id: number;
  /** Whatever stands for the node outside: its element in a page. Problems name it. */
  host?: unknown;
  name?: string | undefined;
  /** The RigidBodyCollection that it belongs to. */
  collection?: PhysicsNode | undefined;
  /** X3D version of the file it stands in, which says its defaults; 4 where nobody says. */
  version?: number | undefined;
  /** The node itself, where it was made before the code of its class was here. */
  early?: PhysicsNode;
}

/** What joints need to know of the solver. */
export interface JointSettings {
  /** Share of a joint's error repaired per step. */
  errorCorrection: number;
  constantForceMix: number;
  stepSeconds: number;
}

/** The bodies of a world, as nodes that make them see it. */
export interface BodyTable extends Bodies {
  /** A slot for a body that is being made. */
  take(body: Body): number;
  register(body: Body): void;
  /** Whether Bullet has it among what moves may be another, and so may its size, mass, centre of mass and gravity. */
  review(body: Body): void;
  release(body: Body): void;
  wake(body: Body): void;
  sleep(body: Body): void;
  /** Falls asleep without a word, if it was asleep before the world was restored. */
  restoreSleep(body: Body): void;
}

/** The rules of who collides with whom, as nodes that make and follow them see it. */
export interface PairRules extends Pairs {
  between(first: Collidable, second: Collidable): (Collider & PhysicsNode) | undefined;
  /** Something about membership changed: every body goes to its groups again. */
  refresh(): void;
  refreshBody(body: Body): void;
  /** What contacts of a body are like is to be looked up again. */
  contactsChanged(body: Body): void;
  /** Bullet's collision group and mask of a body. */
  groupsOf(body: Body): [group: number, mask: number];
  /** It is in no group any more. */
  leave(body: Body): void;
  /** A CollisionSpace around it wants its own triangles where a hull would do otherwise. */
  wantsTriangles(collidable: PhysicsNode): boolean;
  addCollection(collection: PhysicsNode): void;
  removeCollection(collection: PhysicsNode): void;
  parametersChanged(): void;
  addSpace(space: PhysicsNode): void;
  removeSpace(space: PhysicsNode): void;
  /** A CollisionSpace has other members, or counts no more. */
  spacesChanged(): void;
}

/** What a node asks of its world. */
export interface NodeWorld extends Simulation {
  readonly bodies: BodyTable;
  readonly pairs: PairRules;
  /** Its effects. */
  readonly registry: Effects;
  readonly events: EventQueue;
  readonly nodes: Iterable<PhysicsNode>;
  /** Settings of the world: its first collection's, or X3D's defaults. */
  readonly settings: PhysicsNode;
  readonly solver: JointSettings;
  readonly counts: { created: number; patched: number; destroyed: number };
  /** Whether there is a Bullet world. */
  readonly started: boolean;

  /** Applies pending edits. */
  flush(): void;
  readonly store: {
    /** Its RigidBodyCollections. */
    readonly collections: Iterable<PhysicsNode>;
    /** A node was added, or fields of it changed. */
    changed(node: PhysicsNode): void;
    /** A node is gone for good. */
    forget(node: PhysicsNode): void;
    /** A node from plain data in a field that takes `types`; undefined: it takes none such. */
    addData(data: NodeData, parent: PhysicsNode, types: readonly string[]): PhysicsNode | undefined;
  };
  readonly failures: {
    /** Does something for a node that may fail; then nothing of the node stays in Bullet. */
    attempt(node: PhysicsNode, act: () => void): void;
  };
  /** Takes the settings of the first collection into Bullet. */
  configure(): void;
  readonly obstacles: {
    /** Collidables that no body owns are looked at after the present edits. */
    due(): void;
  };
  readonly rays: {
    /** Something moved: rays ask anew where everything is. */
    moved(): void;
  };

  report(report: ProblemReport, about?: unknown): void;
  settle(about: unknown, attribute?: string, code?: string): void;
  /** A node is gone, and with it what it reported. */
  takeBack(node: PhysicsNode): void;
}
