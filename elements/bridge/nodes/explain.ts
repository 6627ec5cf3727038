import {
  bulletHas,
  SI,
  touchedBy,
  type PhysicsNode,
  type Problem,
} from '../../../physics-core/index.js';
import type { Binding } from './binding.js';
import { holdsNodes } from './fields.js';
import { inPage } from './in-page.js';
import { rivalOf } from './rivals.js';
import type { PageWorld } from './worlds.js';

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
  /** What Bullet has for it, in SI units and the world's frame; undefined where it has nothing (yet). */
  bullet: Record<string, unknown> | undefined;
  /** Elements of what it touches; undefined for what does not collide. */
  touches: Element[] | undefined;
  /** Why it sleeps; undefined while it is awake. */
  sleeps: string | undefined;
  /** What Bullet can only come near to. */
  approximations: string[];
  problems: Problem[];
}

/** Problems that say what is simulated in the place of what was written. */
const APPROXIMATED = new Set(['approximated-field', 'concave-dynamic', 'zero-volume']);

/** Of an element whose node this is, or whose body; undefined where it has none. */
export function explanation(element: Element, binding: Binding | undefined): Explanation {
  const problems = binding?.world?.problemsOf(binding.element) ?? [];
  const node = binding?.node;
  return {
    type: binding?.type.name,
    name: binding?.name,
    element: binding?.element ?? element,
    running: !!binding?.node && !!binding.world?.started,
    waits: binding ? waitsOf(binding) : [],
    fields: binding ? fieldsOf(binding) : {},
    bullet: node ? (inElements(bulletHas(node)) as Explanation['bullet']) : undefined,
    touches: node ? (inPage(touchedBy(node), SI) as Element[] | undefined) : undefined,
    sleeps: binding && whyAsleep(binding),
    approximations: problems
      .filter(({ code }) => APPROXIMATED.has(code))
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

/** With elements for nodes. */
const inElements = (
  data: Record<string, unknown> | undefined,
): Record<string, unknown> | undefined =>
  data && Object.fromEntries(Object.entries(data).map(([key, value]) => [key, inPage(value, SI)]));

function waitsOf(binding: Binding): string[] {
  if (!binding.scope) return ['an <x3d> around it'];
  const names = [...binding.waiting].map(([role, name]) => `${role} "${name}"`);
  const rival = rivalOf(binding)?.rival;
  if (rival) names.push(`${rival.label} to go`);
  if (!binding.scope.scene.live) return [...names, 'the document to be read'];
  if (!binding.node || !binding.world) return names;
  return [...names, ...waitsOfNode(binding.node, binding.world)];
}

function waitsOfNode(node: PhysicsNode, world: PageWorld): string[] {
  if (!world.started) return ['the physics engine'];
  const waits: string[] = [];
  if ((node as { attached?: boolean }).attached === false) waits.push('its bodies');
  if (!world.enabled) waits.push('enabled of its collection');
  if (world.paused) waits.push('the world, which is paused');
  return waits;
}

function fieldsOf(binding: Binding): Record<string, unknown> {
  const fields: Record<string, unknown> = {};
  for (const [name, field] of Object.entries(binding.type.fields)) {
    if (!holdsNodes(field)) fields[name] = binding.get(name);
  }
  return fields;
}
