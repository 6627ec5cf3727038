import { codecs, type World } from '../../../physics-core/inside.js';
import { jointBody } from '../document/joint-bodies.js';
import { SOFT } from '../document/shortcuts.js';
import { holdersOf, meant, nodesOf, placesOf } from '../document/structure.js';
import { worldFor } from '../document/world-for.js';
import { isIdentity } from '../geometry/matrix.js';
import { worldAround } from '../matter/world-of.js';
import { ownBinding, type Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { collectionNode, nodesIn, type Plan } from '../plans/plan.js';
import { isPhysics } from '../words/dom.js';
import { frameOf, inWorld } from '../matter/frame.js';

/** The ropes, cloths and soft bodies that it stands in. */
const around = (attachment: Binding): Binding[] =>
  placesOf(attachment).flatMap((place) => holdersOf(place, attachment, ...SOFT));

/** What it names by a property, an attribute or a child; else what it stands in. */
function softOf(attachment: Binding): Binding | 'missing' | undefined {
  const [given] = attachment.named('softBody') ?? [];
  if (given) return meant(attachment, given, 'softBody');
  const name = attachment.authored('softBody');
  if (typeof name === 'string' && name.trim()) return named(attachment, name.trim());
  for (const child of attachment.element.children) hear(attachment, child);
  for (const { parentElement } of placesOf(attachment))
    if (parentElement) hear(attachment, parentElement);
  return nodesOf(attachment, 'softBody', ...SOFT)[0] ?? around(attachment)[0];
}

/** What reads the tag of a cloth or a soft body may come later than what ties it. */
function hear(attachment: Binding, element: Element): void {
  if (!isPhysics(element)) attachment.scene!.readers.add(element, attachment);
}

function named(attachment: Binding, name: string): Binding | 'missing' {
  const element = attachment.scope!.find(name, attachment);
  const soft = element && ownBinding(element);
  if (soft?.is(...SOFT)) return soft;
  if (element) hear(attachment, element);
  attachment.waitFor('softBody', name);
  return 'missing';
}

/** That of what it ties; else of its body. */
export function worldOfAttachment(attachment: Binding): PageWorld | undefined {
  const soft = softOf(attachment);
  const body = jointBody(attachment, 'body');
  for (const other of [soft, body])
    if (other && other !== 'missing' && other.scope) return worldFor(other);
  return worldAround(attachment);
}

export function planAttachment(attachment: Binding, world: World): Plan | undefined {
  const soft = softOf(attachment);
  const body = jointBody(attachment, 'body');
  // Half of it would hold it to the wrong place.
  if (soft === 'missing' || body === 'missing') return undefined;
  if (soft && body) tellApart(attachment, soft, body);
  const node = (other: Binding | undefined): unknown =>
    other ? nodesIn(world, [other], attachment)[0] : null;
  const relations: Record<string, unknown> = { softBody: node(soft), body: node(body) };
  if (relations.softBody === undefined || relations.body === undefined) return undefined;
  if (!body) Object.assign(relations, placed(attachment));
  return { world, collection: collectionNode(attachment), relations };
}

/** Nothing ties what is in two worlds. */
function tellApart(attachment: Binding, soft: Binding, body: Binding): void {
  if (!soft.world || !body.world || soft.world === body.world) return;
  attachment.problem({
    code: 'unknown-reference',
    severity: 'warning',
    attribute: 'body',
    value: body.name,
    used: 'nothing',
    message: `${attachment.label} ties nothing: ${body.label} is in another world than ${soft.label}`,
  });
}

/** Where it says in its frame, as it is in the world. */
function placed(attachment: Binding): Record<string, unknown> {
  const [soft = attachment] = around(attachment);
  const frame = frameOf(soft, attachment);
  if (isIdentity(frame)) return {};
  const asked = attachment.authoredFields().position ?? [0, 0, 0];
  const position = (codecs.SFVec3f.accept(asked) ?? [0, 0, 0]) as number[];
  return { position: inWorld(frame, position, attachment.units.length) };
}
