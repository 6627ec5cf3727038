import { attribute } from '../words/dom.js';
import { collidablesIn } from './structure.js';
import type { Binding } from '../nodes/binding.js';

// Two bodies in one place would push each other apart: the second in document order waits until the first has gone.

/** What a body stands for by itself, and by its collidables. */
const partsOf = (binding: Binding): Binding[] =>
  binding.is('RigidBody')
    ? [binding, ...collidablesIn(binding, 'geometry').map((part) => binding.use(part))]
    : [binding];

/** The body that moves already what `binding` is to move. */
export function rivalOf(binding: Binding): { part: Binding; rival: Binding } | undefined {
  for (const part of partsOf(binding)) {
    const rival = part.scene?.drivers.rivalOf(part);
    if (rival && rival !== binding) return { part, rival };
  }
  return undefined;
}

/** Whether nobody moves it yet; of a body with its collidables the body tells. */
export function mayMove(binding: Binding): boolean {
  const found = rivalOf(binding);
  if (found && binding.is('RigidBody')) tell(binding, found.part, found.rival);
  return !found;
}

function tell(binding: Binding, part: Binding, rival: Binding): void {
  const { transform, shapes } = part.standIn!;
  const role = attribute(part.element, 'for') ? 'for' : 'geometry';
  binding.fault((faults) => faults.rival(binding, transform ?? shapes, rival.label, role));
}
