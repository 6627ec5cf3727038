import type { Body } from './body.js';
import type { Collidable } from './collidable.js';
import type { ContactParameters } from './contact-parameters.js';
import type { SimulationNode } from './node.js';

/** Members that collide, and what their contacts are like: a CollisionCollection. */
export interface Collider extends SimulationNode {
  readonly enabled: boolean;
  readonly parameters: ContactParameters;
}

/** Who collides with whom, and who gives a pair its parameters. */
export interface Pairs {
  /** Those that list one of the body's collidables. */
  collectionsOf(body: Body): readonly Collider[];
  /** Whether contacts of a body may only act where set_contacts hands them on. */
  waits(body: Body): boolean;
  /** Whether Bullet looks for contacts of two collidables of two bodies, joints aside. */
  meet(a: Body, first: Collidable, b: Body, second: Collidable): boolean;
  /** Whether they collide without being asked to: not where contacts wait for set_contacts. */
  collide(a: Body, first: Collidable, b: Body, second: Collidable): boolean;
  /** Whether a collider speaks for a pair of collidables. */
  speaksFor(collider: Collider, first: Collidable, second: Collidable): boolean;
  /** The collider that gives a pair its parameters: the first enabled one that speaks for it. */
  between(first: Collidable, second: Collidable): Collider | undefined;
  /** A sensor looks at something else. */
  watchChanged(): void;
}
