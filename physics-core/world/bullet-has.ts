import { add } from '../base/math.js';
import { POSE } from '../dynamics/poses.js';
import { water } from '../effects/water/effects.js';
import { contacts } from '../effects/effect/chunks.js';
import type { LevelName } from '../dynamics/levels.js';
import type { BulletWorld } from '../engine/bullet-world.js';
import { kindOf } from '../engine/shape-kind.js';
import { BodyNode } from '../nodes/body/body.js';
import { CollidableNode } from '../nodes/collision/collidable.js';
import { isJoint } from '../nodes/joints/is-joint.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import { CollectionNode } from '../nodes/collection-node.js';
import type { NodeWorld } from '../nodes/node/node-world.js';
import type { BtShape } from '../shapes/build.js';
import type { Stats } from './store/types.js';

/** What knows itself what stands for it. */
type Shown = PhysicsNode & { inBullet: Record<string, unknown> | undefined };

/** How plain data names a node. */
type NameOf = (node: PhysicsNode) => string;

/**
 * What Bullet has for a node, as plain data in SI units and the world's frame, with other nodes by name; undefined where
 * it has nothing.
 */
export function bulletHas(
  node: PhysicsNode,
  nameOf: NameOf = ({ label }) => label,
): Record<string, unknown> | undefined {
  node.world.flush();
  if (!node.built || !node.world.started) return undefined;
  if (node instanceof BodyNode) return bodyIn(node, nameOf);
  if ('inBullet' in node) return (node as Shown).inBullet;
  if (node instanceof CollidableNode)
    return node.owner?.built ? { shapeOf: nameOf(node.owner.standsFor) } : undefined;
  return node instanceof CollectionNode ? worldIn(node) : undefined;
}

function bodyIn(body: BodyNode, nameOf: NameOf): Record<string, unknown> {
  const { reader } = body.world.engine;
  const pose = new Float64Array(POSE);
  const velocity = new Float64Array(6);
  reader.pose(body.pointer, pose, 0);
  reader.velocity(body.pointer, velocity, 0);
  return {
    state: stateOf(body),
    shapes: shapesOf(body),
    mass: body.movable ? body.mass.mass : 0,
    principalMoments: body.movable ? [...body.mass.moments] : [0, 0, 0],
    centerOfMass: add([pose[0]!, pose[1]!, pose[2]!], body.world.poses.origin),
    principalAxes: [...pose.subarray(3)],
    linearVelocity: [...velocity.subarray(0, 3)],
    angularVelocity: [...velocity.subarray(3)],
    gravity: [...body.gravity],
    water: body.world.registry.find(water)?.known(body),
    joints: [...body.joints].flatMap((joint) =>
      joint.attached && isJoint(joint) ? [nameOf(joint)] : [],
    ),
  };
}

function stateOf(body: BodyNode): string {
  if (!body.active) return body.parked ? 'taken out: no finite numbers' : 'taken out: not enabled';
  if (body.body.isKinematicObject()) return 'carried';
  if (body.body.isStaticObject()) return 'fixed';
  return body.sleeping ? 'asleep' : 'awake';
}

/** The kinds of shapes it collides with, and the margin of each, metres. */
function shapesOf(body: BodyNode): { type: string; margin: number }[] {
  const { engine } = body.world;
  const { ammo } = engine;
  const nameOf = (shape: BtShape): string => kindOf(engine, shape) ?? 'unknown';
  const whole = body.body.getCollisionShape();
  if (nameOf(whole) !== 'compound') return [{ type: nameOf(whole), margin: whole.getMargin() }];
  const compound = ammo.castObject(whole, ammo.btCompoundShape);
  return Array.from({ length: compound.getNumChildShapes() }, (_, i) => {
    const child = compound.getChildShape(i);
    return { type: nameOf(child), margin: child.getMargin() };
  });
}

/** What is known of a world as a whole. */
interface KnownWorld extends NodeWorld {
  readonly accuracy: LevelName;
  readonly stats: Stats;
  readonly bullet: BulletWorld;
}

function worldIn(collection: CollectionNode): Record<string, unknown> {
  const world = collection.world as KnownWorld;
  const { iterations, contactErrorReduction, linearSlop } = world.bullet.settings;
  const { bodies, joints, contacts } = world.stats;
  const solver = { iterations, contactErrorReduction, linearSlop };
  return { level: world.accuracy, timeStep: world.timeStep, ...solver, bodies, joints, contacts };
}

/** What a body, or a collidable without one, touches now; undefined for other nodes, and where steps are taken elsewhere. */
export function touchedBy(node: PhysicsNode): PhysicsNode[] | undefined {
  const body = node instanceof CollidableNode ? node.obstacle : node;
  if (!(body instanceof BodyNode) || !body.built || !body.world.started) return undefined;
  if (body.world.events.silent) return undefined;
  // Without that code there is no second body.
  const others = contacts.here ? contacts.code.touchedBy(body.world, body) : [];
  return [...new Set([...others].map((other) => (other as BodyNode).standsFor))];
}
