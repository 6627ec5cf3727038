// Effects whose code weighs something come together with those that the same things cause.
import { Chunk } from '../../base/chunk.js';
import type { Body } from '../../dynamics/body.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Reported } from './reported.js';

/** A world whose contacts are looked at. */
export interface PiledWorld extends Simulation {
  /** The level in force. */
  readonly accuracy: LevelName;
  settle(about: unknown, attribute?: string, code?: string): void;
}

/** What tells of what contacts do not hold. */
export interface HardContacts {
  /** After a step of `dt` seconds. */
  look(dt: number): void;
  /** Nothing is known of what was before. */
  forget(): void;
}

/** A node that says what contacts are like: a CollisionCollection or a Contact. */
export interface ParameterNode {
  readonly world: { readonly settings: { asked<T>(field: string): T } };
  asked<T>(field: string): T;
  authored(field: string): boolean;
}

/** What is asked about contacts beside what effects do with them. */
export interface ContactCode {
  hardContacts(world: PiledWorld): HardContacts;
  /** Tells of bodies that the first step found inside each other. */
  reportOverlaps(simulation: Simulation): void;
  /** What a body touches now. */
  touchedBy(simulation: Simulation, body: Body): Set<Body>;
  /** Tells of words in contacts' appliedParameters that no parameter has. */
  reportGiven(giver: Reported, contacts: readonly ParameterNode[]): void;
  reportOneSided(collection: Reported, is: boolean): void;
}

export const joints = new Chunk({ name: 'joints', causes: 'a joint' });

export const contacts = new Chunk<ContactCode>({
  name: 'contacts',
  causes:
    'a second RigidBody in the same world, or a fixed one, a CollisionCollection, a CollisionSpace, a CollisionSensor or a Contact',
});
