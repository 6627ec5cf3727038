import type { Binding } from '../nodes/binding.js';
import { attribute, isPhysics, isTransform } from '../words/dom.js';
import { multiply, type Affine } from '../geometry/matrix.js';
import type { StandIn } from '../nodes/stand-in.js';
import type { Scope } from '../scopes/scope.js';
import { placesOf } from './structure.js';
import { drivenMatrix, matrixAbove, transformsAbove } from '../scopes/transforms.js';

/** Shortcut 2: `for="ID"` names a Transform, a Shape or a group. */
function named(binding: Binding, name: string): StandIn | undefined {
  const scope = binding.scope!;
  const element = scope.find(name, binding);
  if (!element) {
    binding.waitFor('for', name);
    return undefined;
  }
  const at = scope.all.around(element) ?? scope;
  const transform = isTransform(element) ? element : transformsAbove(element, at)[0];
  return { scope: at, transform, shapes: element };
}

/** Shortcut 1: a body, water, a rope, a cloth or a soft body inside a Transform, with nothing of physics between them. */
function enclosing(binding: Binding): StandIn | undefined {
  for (const place of placesOf(binding)) {
    const found = transformAround(place, binding.scope!.all.around(place) ?? binding.scope!);
    if (found) return found;
  }
  return undefined;
}

function transformAround(place: Element, scope: Scope): StandIn | undefined {
  for (let at = place.parentElement; at && at !== scope.root; at = at.parentElement) {
    if (isPhysics(at)) return undefined;
    if (isTransform(at)) return { scope, transform: at, shapes: at };
  }
  return undefined;
}

/** X3DOM's older dialect: `<CollidableShape><Transform USE='x' containerField='transform'/></CollidableShape>`. */
function dialect(binding: Binding): StandIn | undefined {
  const scope = binding.scope!;
  for (const child of binding.element.children) {
    const use = isTransform(child) ? attribute(child, 'USE') : null;
    const transform = use ? scope.find(use, binding) : undefined;
    if (transform) return { scope, transform, shapes: transform };
  }
  return undefined;
}

/** A Transform that stands for another one by USE is that one. */
function resolved(standIn: StandIn | undefined, binding: Binding): StandIn | undefined {
  const use = standIn?.transform && attribute(standIn.transform, 'USE');
  const transform = use ? standIn.scope.find(use, binding) : undefined;
  return transform ? { ...standIn!, transform, shapes: transform } : standIn;
}

/** What a SoftBodyAttachment ties. */
export const SOFT = ['Rope', 'Cloth', 'SoftBody'];

export function standInOf(binding: Binding): StandIn | undefined {
  return resolved(shortcutOf(binding), binding);
}

function shortcutOf(binding: Binding): StandIn | undefined {
  const name = attribute(binding.element, 'for');
  if (name) return named(binding, name);
  if (binding.is('RigidBody', 'WaterVolume', ...SOFT, 'SoftBodyAttachment'))
    return enclosing(binding);
  return binding.is('CollidableShape') ? dialect(binding) : undefined;
}

/** World matrix of what a stand-in moves, as drawn now. */
export function standInMatrix({ transform, shapes, scope }: StandIn): Affine {
  const frame = transform ?? shapes;
  const above = matrixAbove(frame, scope);
  return transform && isTransform(transform)
    ? multiply(above, drivenMatrix(transform, scope))
    : above;
}
