import { MANIFOLD_POINT as POINT } from '../engine/offsets.js';
import type { BodyNode } from '../nodes/body.js';
import type { CollidableNode } from '../nodes/collidable.js';
import type { CollisionSensorNode } from '../nodes/collision-sensor.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** A resting sphere has a distance of 1.5e-16 in some steps, so touching needs a tolerance, metres. */
const TOUCHING = 0.0005;

/** Reads what touches after each step, for CollisionSensors. */
export class ContactReader extends Effect {
  readonly name = 'contact reading';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override afterStep(): void {
    const touching = new Map<CollisionSensorNode, Set<CollidableNode>>();
    for (const node of this.causes) touching.set(node as CollisionSensorNode, new Set());
    this.#eachContact((a, b) => {
      for (const [sensor, found] of touching) if (watches(sensor, a, b)) found.add(a).add(b);
    });
    for (const [sensor, found] of touching) sensor.sense([...found]);
  }

  #eachContact(visit: (a: CollidableNode, b: CollidableNode) => void): void {
    const { ammo } = this.#world.engine;
    this.#world.bullet.eachManifold((manifold, pointerA, pointerB) => {
      const count = manifold.getNumContacts();
      if (count === 0) return;
      const bodyA = this.#world.bodyAt(pointerA);
      const bodyB = this.#world.bodyAt(pointerB);
      if (!bodyA || !bodyB) return;
      for (let i = 0; i < count; i++) {
        const point = manifold.getContactPoint(i);
        if (point.getDistance() > TOUCHING) continue;
        const at = ammo.getPointer(point);
        const a = collidableAt(bodyA, ammo.HEAP32[(at + POINT.index0) >> 2]!);
        const b = collidableAt(bodyB, ammo.HEAP32[(at + POINT.index1) >> 2]!);
        if (a && b) visit(a, b);
      }
    });
  }
}

/** `index`: the child of a compound that touches; -1 or a triangle's number where the body has one part. */
function collidableAt(body: BodyNode, index: number): CollidableNode | undefined {
  const { parts } = body;
  return (parts.length > 1 ? parts[index] : parts[0])?.collidable;
}

function watches(sensor: CollisionSensorNode, a: CollidableNode, b: CollidableNode): boolean {
  const collider = sensor.collider!;
  return collider.asked<boolean>('enabled') && collider.lists(a) && collider.lists(b);
}
