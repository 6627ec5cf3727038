import type { PhysicsNode, Vec3, World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import type { GeometryData } from '../geometry/geometry-fields.js';
import type { Pose, Quaternion } from '../geometry/matrix.js';
import type { Target } from '../drawing/drawing.js';
import { collectionOf } from '../document/structure.js';

/** A pose in SI, as the core takes it. */
export interface StartPose {
  p: Vec3;
  q: Quaternion;
}

export const inMetres = ({ position, quaternion }: Pose, length: number): StartPose => ({
  p: [position[0] * length, position[1] * length, position[2] * length],
  q: quaternion,
});

/** The Transform that a body stands for, and what `for` says. */
export interface Place {
  transform: Element | undefined;
  name: string | null;
}

/** What one node is to be in the core, beside the values of its own fields. */
export interface Plan {
  world: World;
  collection?: PhysicsNode | undefined;
  /** Fields that hold nodes, and those that the bridge reads otherwise than their attribute says. */
  relations: Record<string, unknown>;
  start?: StartPose | undefined;
  /** Of a body: what `for`, at it or at its collidable, makes it stand for. */
  place?: Place;
  targets?: Target[];
  /** Geometry of a body that stands for its Transform's Shapes. */
  shapes?: GeometryData[] | undefined;
}

/** The nodes of bindings that live in `world`. */
export function nodesIn(world: World, bindings: Binding[], user: Binding): PhysicsNode[] {
  const nodes: PhysicsNode[] = [];
  for (const binding of bindings) {
    user.use(binding);
    if (binding.node && binding.world === world) nodes.push(binding.node);
  }
  return nodes;
}

/** The node of the collection that a node belongs to. */
export function collectionNode(binding: Binding): PhysicsNode | undefined {
  const { worlds } = binding.scene!;
  const collection =
    collectionOf(binding) ??
    (worlds.isDefault(binding.world) ? worlds.defaultCollection() : undefined);
  return collection && (binding.use(collection).node ?? undefined);
}
