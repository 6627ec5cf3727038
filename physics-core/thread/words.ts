import type { Body } from '../dynamics/body.js';
import type { BodyNode } from '../nodes/body/body.js';
import { contact } from '../nodes/collision/contact.js';
import { ContactNode } from '../nodes/collision/contact-node.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import type { Value } from '../fields/types.js';
import { decode, encode } from '../timeline/calls.js';
import type { World } from '../world/world.js';

// What one world tells of, as plain data, and the same in the other world. Contacts that a sensor found have no number:
// they go as what was found.

type NodeOf = (id: number) => PhysicsNode | undefined;

interface Found {
  contact: { fields: unknown; pair: unknown[]; collection: number | undefined };
}

const FIELDS = Object.keys(contact.fields);

const bodyOf = (body: Body): PhysicsNode => (body as BodyNode).standsFor as PhysicsNode;

function found(node: ContactNode): Found {
  const fields = FIELDS.filter((name) => node.authored(name)).map((name) => [
    name,
    encode(node.asked(name)),
  ]);
  return {
    contact: {
      fields: Object.fromEntries(fields),
      pair: node.pair!.map((body) => bodyOf(body).id),
      collection: node.collection?.id,
    },
  };
}

export const tell = (value: unknown): unknown => {
  if (Array.isArray(value)) return value.map(tell);
  return value instanceof ContactNode && value.pair ? found(value) : encode(value);
};

/** What was told, in this world. */
export function hear(value: unknown, world: World, node: NodeOf): unknown {
  if (Array.isArray(value)) return value.map((item) => hear(item, world, node));
  const isFound = typeof value === 'object' && value !== null && 'contact' in value;
  return isFound ? contactIn(world, value as Found, node) : decode(value, node);
}

function contactIn(world: World, { contact: of }: Found, node: NodeOf): ContactNode {
  const context = { world, type: contact, id: 0, collection: node(of.collection ?? 0) };
  const fields = decode(of.fields, node) as Record<string, Value>;
  return new ContactNode(context, {
    fields,
    pair: of.pair.map((id) => node(id as number)) as unknown as [Body, Body],
  });
}
