import type { PhysicsNode, Problem } from '../../../physics-core/index.js';
import type { Binding } from './binding.js';
import { holdsNodes } from './fields.js';
import { page } from '../page.js';

/** What there is to know about one element, as plain data. */
export interface Explanation {
  /** X3D name of the node; undefined when nothing of physics moves the element. */
  type: string | undefined;
  name: string | undefined;
  element: Element;
  /** Whether its node stands in a running world. */
  running: boolean;
  /** What it waits for, in words. */
  waits: string[];
  /** Live values in the units of its file. */
  fields: Record<string, unknown>;
  /** Elements of what it touches; known while somebody listens to its collision events. */
  touches: Element[] | undefined;
  /** Why it sleeps; undefined while it is awake. */
  sleeps: string | undefined;
  /** What Bullet can only come near to. */
  approximations: string[];
  problems: Problem[];
}

/** Of a physics element, or of the body that moves any other one. */
export function explain(element: Element): Explanation {
  const binding = page.bindingOf(element) ?? page.bodyOf(element);
  const problems = binding?.world?.problemsOf(binding.element) ?? [];
  return {
    type: binding?.type.name,
    name: binding?.name,
    element: binding?.element ?? element,
    running: !!binding?.node && !!binding.world?.started,
    waits: binding ? waitsOf(binding) : [],
    fields: binding ? fieldsOf(binding) : {},
    touches: binding?.scope?.scene.events.touching(binding),
    sleeps: binding && whyAsleep(binding),
    approximations: problems
      .filter(({ code }) => code === 'approximated-field')
      .map(({ message }) => message),
    problems,
  };
}

function whyAsleep({ node }: Binding): string | undefined {
  const body = node as (PhysicsNode & { sleeping?: boolean }) | null;
  if (!body?.sleeping) return undefined;
  const asks = (each: PhysicsNode): boolean => each.authored('autoDisable');
  const asked = [body, ...(body.collection ? [body.collection] : [])].find(asks);
  return asked?.get('autoDisable')
    ? 'autoDisable: its speeds stayed below its limits for disableTime'
    : 'it and all that it touches had come to rest, or it was put to sleep';
}

function waitsOf(binding: Binding): string[] {
  if (!binding.scope) return ['an <x3d> around it'];
  const names = [...binding.waiting].map(([role, name]) => `${role} "${name}"`);
  if (!binding.scope.scene.live) return [...names, 'the document to be read'];
  return binding.node && !binding.world?.started ? [...names, 'the physics engine'] : names;
}

function fieldsOf(binding: Binding): Record<string, unknown> {
  const fields: Record<string, unknown> = {};
  for (const [name, field] of Object.entries(binding.type.fields)) {
    if (!holdsNodes(field)) fields[name] = binding.get(name);
  }
  return fields;
}
