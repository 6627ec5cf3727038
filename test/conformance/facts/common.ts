import { near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { nodesIn, renamed } from '../markup.js';
import { looks } from './particle-looks.js';

// The fields that say nothing about motion: of every node, of those with a bounding box, descriptions, looks of particles.

const metadata = (value: string): NodeData => ({
  type: 'MetadataString',
  name: 'note',
  value: [value],
});

/** What each is written as, and the event that follows; an initializeOnly field takes none. */
const VALUES: Record<string, { written: unknown; event?: unknown }> = {
  metadata: { written: metadata('first'), event: metadata('second') },
  bboxCenter: { written: [1, 2, 3] },
  bboxSize: { written: [0.1, 0.2, 0.3] },
  bboxDisplay: { written: true, event: false },
  visible: { written: false, event: true },
  description: { written: 'some words', event: 'other words' },
  ...looks,
};

const BOUNDED = ['metadata', 'bboxCenter', 'bboxSize', 'bboxDisplay', 'visible'];

const FIELDS: Record<string, string[]> = {
  RigidBodyCollection: BOUNDED,
  RigidBody: BOUNDED,
  CollidableShape: BOUNDED,
  CollidableOffset: BOUNDED,
  CollisionSpace: BOUNDED,
  CollisionCollection: [...BOUNDED, 'description'],
  CollisionSensor: ['metadata', 'description'],
  Rope: BOUNDED,
  Cloth: BOUNDED,
  SoftBody: BOUNDED,
  WaterVolume: BOUNDED,
  ParticleSystem: [...BOUNDED, ...Object.keys(looks)],
};

function namesOf(type: string, scene: NodeData[]): string[] {
  return scene.flatMap((node) => [
    ...(node.type === type && node.DEF ? [node.DEF] : []),
    ...Object.values(node).flatMap((value) => namesOf(type, nodesIn(value) ?? [])),
  ]);
}

/** The scene with a name for every node of a type, and with `fields` written on them. */
function written(type: string, fields: Record<string, unknown>, scene: NodeData[]): NodeData[] {
  let count = 0;
  const change = (node: NodeData): NodeData => {
    const entries = Object.entries(node).map(([field, value]) => {
      const nodes = nodesIn(value)?.map(change);
      return [field, nodes ? (Array.isArray(value) ? nodes : nodes[0]) : value];
    });
    const same = Object.fromEntries(entries) as NodeData;
    return node.type === type ? { DEF: `common${count++}`, ...same, ...fields } : same;
  };
  return scene.map(change);
}

const isWorld = ({ type }: NodeData): boolean => type === 'RigidBodyCollection';

/** Both side by side; a system of particles stands outside of the world that it lives in, so one world has both of them. */
function both(plain: NodeData[], other: NodeData[], moving: Moving): NodeData[] {
  const apart = moving.type === 'ParticleSystem' ? (node: NodeData) => !isWorld(node) : () => true;
  return [
    ...plain.filter((node) => !apart(node)),
    ...renamed(plain.filter(apart), (name) => `plain_${name}`),
    ...renamed(other.filter(apart), (name) => `other_${name}`),
  ];
}

/** What moves in a scene, and what tells where it is. */
interface Moving {
  type: string;
  field: string;
}
const movingIn = (scene: NodeData[]): Moving =>
  namesOf('ParticleSystem', scene).length > 0
    ? { type: 'ParticleSystem', field: 'positions' }
    : { type: 'RigidBody', field: 'position' };

/** Two equals, one of them with the field: all that moves does so in the same way, to the last bit. */
function inert(type: string, field: string, scene: NodeData[]): Fact {
  const value = VALUES[field]!;
  const plain = written(type, {}, scene);
  const other = written(type, { [field]: value.written }, scene);
  const moving = movingIn(plain);
  return {
    field,
    says: 'changes nothing in the motion',
    inert: true,
    scene: both(plain, other, moving),
    run: async (x) => {
      await x.advance(0.25);
      if (value.event !== undefined)
        for (const name of namesOf(type, other)) await x.set(`other_${name}`, field, value.event);
      await x.advance(0.25);
      const checks = [];
      for (const name of namesOf(moving.type, plain)) {
        const [expected, actual] = [
          await x.get(`plain_${name}`, moving.field),
          await x.get(`other_${name}`, moving.field),
        ];
        checks.push(near(`${name} after 0.5 s`, actual.flat(), expected.flat(), 0, 'm'));
      }
      return checks;
    },
  };
}

/** The facts of a node's common fields, in the first of its scenes of which nothing is told. */
export function commonFacts(type: string, facts: Fact[]): Fact[] {
  const found = facts.find(
    ({ scene, tells }) => !tells && JSON.stringify(scene).includes(`"type":"${type}"`),
  );
  if (!found) return [];
  const proved = new Set(facts.map(({ field }) => field));
  return (FIELDS[type] ?? ['metadata'])
    .filter((field) => !proved.has(field))
    .map((field) => inert(type, field, found.scene));
}
