import type { World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import type { StandIn } from '../nodes/stand-in.js';
import { attribute } from '../words/dom.js';
import { drawn } from '../drawing/targets.js';
import type { GeometryData } from '../geometry/geometry-fields.js';
import { GeometryReader, noteWaiting } from '../document/geometry-reader.js';
import { decompose, identity, isIdentity, withLinear } from '../geometry/matrix.js';
import { collidableMatrix } from '../document/collidable-pose.js';
import {
  collectionNode,
  inMetres,
  nodesIn,
  type Place,
  type Plan,
  type StartPose,
} from './plan.js';
import { standInMatrix } from '../document/shortcuts.js';
import { collidablesIn, ownerOf } from '../document/structure.js';

export function planBody(binding: Binding, world: World): Plan {
  const collidables = ownCollidables(binding);
  const plan: Plan = {
    world,
    collection: collectionNode(binding),
    relations: { geometry: nodesIn(world, collidables, binding) },
    targets: [],
    place: placeOf(binding.standIn ? binding : collidables.find(({ standIn }) => standIn)),
  };
  const model = massModel(binding);
  if (model) plan.relations.massDensityModel = model;
  if (binding.standIn) standFor(binding, binding.standIn, plan, collidables.length === 0);
  else if (!binding.wrote('position', 'orientation')) plan.start = startOf(collidables, binding);
  for (const collidable of collidables) plan.targets!.push(...drawn(collidable, binding));
  return plan;
}

/** The Transform that a body stands for, and the name by which it does. */
const placeOf = (by: Binding | undefined): Place => ({
  transform: by?.standIn?.transform,
  name: by ? attribute(by.element, 'for') : null,
});

/** The collidables under a body that no earlier body owns. */
function ownCollidables(binding: Binding): Binding[] {
  return collidablesIn(binding, 'geometry').filter((collidable) => {
    binding.use(collidable);
    const owner = collidable.scope && ownerOf(collidable);
    if (owner === binding) return true;
    binding.fault((faults) => faults.owned(collidable, owner?.label, binding.label, 'USE'));
    return false;
  });
}

function massModel(binding: Binding): GeometryData | undefined {
  const reader = new GeometryReader(binding);
  const elements = binding.named('massDensityModel') ?? [...binding.element.children];
  return reader.single(elements, binding.scope!);
}

function standFor(binding: Binding, standIn: StandIn, plan: Plan, takeShapes: boolean): void {
  const drawn = decompose(standInMatrix(standIn));
  const { linear } = drawn;
  plan.start = inMetres(drawn, standIn.scope.units.length);
  if (standIn.transform)
    plan.targets!.push({ element: standIn.transform, scope: standIn.scope, linear });
  if (takeShapes) plan.shapes = shapesOf(binding, standIn, linear);
}

function shapesOf(
  binding: Binding,
  standIn: StandIn,
  linear: number[] | undefined,
): GeometryData[] {
  const reader = new GeometryReader(binding);
  reader.collect(standIn.shapes, standIn.scope, withLinear(identity(), linear));
  noteWaiting(binding, reader);
  return reader.found;
}

/** A body without a pose of its own starts where its collidable stands. */
function startOf(collidables: Binding[], body: Binding): StartPose | undefined {
  const first = collidables.find((collidable) => collidable.is('CollidableShape'));
  if (!first?.scope) return undefined;
  const placed = first.wrote('translation', 'rotation');
  const matrix = !placed && first.standIn ? standInMatrix(first.standIn) : collidableMatrix(first);
  if (!placed && !first.standIn && isIdentity(matrix)) return undefined;
  return inMetres(decompose(matrix), body.units.length);
}
