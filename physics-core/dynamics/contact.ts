import type { Vec3 } from '../fields/types.js';
import type { Body } from './body.js';
import type { Collidable } from './collidable.js';
import type { ContactParameters } from './contact-parameters.js';
import type { SimulationNode } from './node.js';

/** Where two collidables touch: world frame, metres; the normal points into the first, a negative depth is a gap. */
export interface Touching {
  readonly position: Vec3;
  readonly normal: Vec3;
  readonly depth: number;
  readonly first: Collidable | null;
  readonly second: Collidable | null;
}

/** A contact as page code sees, changes and hands it on. */
export interface Contact {
  /** As it says now. */
  readonly touching: Touching;
  /** As a sensor found it; undefined: page code made it. */
  readonly found: Touching | undefined;
  /** Bodies of the point as Bullet has them; undefined: page code made it. */
  readonly pair: readonly [Body, Body] | undefined;
  /** Body1 and body2: those named, or those of the geometries. */
  readonly bodies: readonly (Body | undefined)[];
  /** Page code wrote something, or made it. */
  readonly isChanged: boolean;
  readonly parameters: ContactParameters;
  wakeBodies(): void;
}

/** Who hands on contacts for the next step: a RigidBodyCollection. */
export interface ContactGiver extends SimulationNode {
  /** With a collider a list only changes parameters. */
  readonly hasCollider: boolean;
}
