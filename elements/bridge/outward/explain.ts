import {
  bulletHas,
  show,
  touchedBy,
  type PhysicsNode,
  type Problem,
  type World,
} from '../../../physics-core/inside.js';
import { selectorOf } from '../words/dom.js';
import type { Binding } from '../nodes/binding.js';
import { holdsNodes } from '../words/fields.js';
import { rivalOf } from '../document/rivals.js';

/** A problem, with the element by name. */
type PlainProblem = Omit<Problem, 'element'> & { element: string };

/**
 * What there is to know about one element, as plain data: it may be kept, cloned, sent or printed. Elements are named by
 * tag and id or DEF, as `querySelector` takes them. What there is not is left out.
 */
export interface Explanation {
  /** X3D name of the node; undefined when nothing of physics moves the element. */
  type?: string | undefined;
  name?: string | undefined;
  /** The one that it tells of: for a Transform or a Shape that of the body. */
  element: string;
  /** Whether its node stands in a running world. */
  running: boolean;
  /** What it waits for, in words. */
  waits: string[];
  /** Live values in the units of its file. */
  fields: Record<string, unknown>;
  /** What Bullet has for it, in SI units and the world's frame; undefined where it has nothing (yet). */
  bullet?: Record<string, unknown> | undefined;
  /** The elements that it touches; undefined for what does not collide. */
  touches?: string[] | undefined;
  /** How it is drawn, and why; undefined where only a few bodies are. */
  drawing?: string | undefined;
  /** Why it sleeps; undefined while it is awake. */
  sleeps?: string | undefined;
  /** What Bullet can only come near to. */
  approximations: string[];
  problems: PlainProblem[];
}

/** What Bullet knows of a node, here or where its world runs. */
export interface Known {
  bullet?: Record<string, unknown> | undefined;
  touches?: PhysicsNode[] | undefined;
}

const knownOf = (node: PhysicsNode | null | undefined): Known =>
  node ? { bullet: bulletHas(node, nodeName), touches: touchedBy(node) } : {};

/** Problems that say what is simulated in the place of what was written. */
const APPROXIMATED = new Set(['approximated-field', 'concave-dynamic', 'zero-volume']);

/** Of an element whose node this is, or whose body; undefined where it has none. */
export function explanation(
  element: Element,
  binding: Binding | undefined,
  known: Known = knownOf(binding?.node),
): Explanation {
  const problems = binding?.scene?.reports.of(binding) ?? [];
  return plain({
    type: binding?.type.name,
    name: binding?.name,
    element: selectorOf(binding?.element ?? element),
    running: !!binding?.node && !!binding.world?.started,
    waits: binding ? waitsOf(binding) : [],
    fields: binding ? fieldsOf(binding) : {},
    bullet: known.bullet,
    touches: known.touches?.map(nodeName),
    drawing: binding?.world?.drawing?.explain(binding),
    sleeps: binding && whyAsleep(binding),
    approximations: problems
      .filter(({ code }) => APPROXIMATED.has(code))
      .map(({ message }) => message),
    problems: problems.map((problem) => ({ ...problem, element: selectorOf(binding!.element) })),
  });
}

/** A node is known by its element. */
const nodeName = ({ host, label }: PhysicsNode): string =>
  host instanceof Element ? selectorOf(host) : label;

/** Deeper than anything of ours: what somebody gave for a value may hold itself. */
const DEEPEST = 6;

/** Numbers, words, and lists and records of them stay; anything else that was given for a value is put in words. */
function plain<T>(value: T, depth?: number): T;
function plain(value: unknown, depth = 0): unknown {
  if (isPlain(value)) return value;
  if (depth > DEEPEST) return show(value);
  if (Array.isArray(value)) return value.map((item: unknown) => plain(item, depth + 1));
  if (Object.getPrototypeOf(value) !== Object.prototype) return show(value);
  const entries = Object.entries(value as object).filter(([, one]) => one !== undefined);
  return Object.fromEntries(entries.map(([name, one]) => [name, plain<unknown>(one, depth + 1)]));
}

const isPlain = (value: unknown): boolean =>
  value === null ||
  ['string', 'boolean', 'undefined'].includes(typeof value) ||
  Number.isFinite(value);

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
  const rival = rivalOf(binding)?.rival;
  if (rival) names.push(`${rival.label} to go`);
  if (!binding.scene?.live) return [...names, 'the document to be read'];
  if (!binding.node || !binding.world) return names;
  return [...names, ...waitsOfNode(binding.node, binding.world)];
}

function waitsOfNode(node: PhysicsNode, world: World): string[] {
  if (!world.started) return ['the physics engine'];
  const waits: string[] = [];
  if ((node as { attached?: boolean }).attached === false) waits.push('its bodies');
  if (!world.get('enabled')) waits.push('enabled of its collection');
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
