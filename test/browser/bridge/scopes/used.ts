/** Scenes in which one node stands somewhere else, by its DEF, and is meant by USE wherever it is a field's value. */
export interface Node {
  tag: string;
  def: string;
  attributes?: string;
  children?: Child[];
}
type Child = { node: Node | string; field?: string };

const child = (node: Node | string, field?: string): Child => ({ node, field: field! });

const COORD: Node = {
  tag: 'Coordinate',
  def: 'coord',
  attributes: 'point="-0.4 -0.4 -0.4, 0.4 -0.4 -0.4, 0 -0.4 0.5, 0 0.5 0"',
};
const FACES: Node = {
  tag: 'IndexedFaceSet',
  def: 'faces',
  attributes: 'coordIndex="0 1 2 -1 0 3 1 -1 1 3 2 -1 2 3 0 -1"',
  children: [child(COORD)],
};
const SHAPE: Node = { tag: 'Shape', def: 'shape', children: [child(FACES)] };
const BALL_SHAPE: Node = {
  tag: 'CollidableShape',
  def: 'ballShape',
  children: [child(SHAPE, 'shape')],
};
const MODEL: Node = { tag: 'Sphere', def: 'model', attributes: 'radius="0.5"' };
const BALL: Node = {
  tag: 'RigidBody',
  def: 'ball',
  attributes: 'position="0 2 0" mass="2" angularVelocity="0 0 3"',
  children: [child(BALL_SHAPE, 'geometry'), child(MODEL, 'massDensityModel')],
};
const FLOOR_SHAPE: Node = {
  tag: 'CollidableShape',
  def: 'floorShape',
  children: [
    child(
      {
        tag: 'Shape',
        def: 'floorLook',
        children: [child({ tag: 'Box', def: 'floorBox', attributes: 'size="20 1 20"' })],
      },
      'shape',
    ),
  ],
};
const OFFSET: Node = {
  tag: 'CollidableOffset',
  def: 'offset',
  attributes: 'translation="0 -0.5 0"',
  children: [child(FLOOR_SHAPE, 'collidable')],
};
const FLOOR: Node = {
  tag: 'RigidBody',
  def: 'floor',
  attributes: 'fixed="true"',
  children: [child(OFFSET, 'geometry')],
};
const ARM_SHAPE: Node = {
  tag: 'CollidableShape',
  def: 'armShape',
  children: [
    child(
      {
        tag: 'Shape',
        def: 'armLook',
        children: [child({ tag: 'Box', def: 'armBox', attributes: 'size="0.2 0.2 0.2"' })],
      },
      'shape',
    ),
  ],
};
const ARM: Node = {
  tag: 'RigidBody',
  def: 'arm',
  attributes: 'position="5 3 0"',
  children: [child(ARM_SHAPE, 'geometry')],
};
const JOINT: Node = {
  tag: 'BallJoint',
  def: 'joint',
  attributes: 'anchorPoint="4 3 0"',
  children: [child('post', 'body1'), child('arm', 'body2')],
};
const POST: Node = {
  tag: 'RigidBody',
  def: 'post',
  attributes: 'position="4 3 0" fixed="true"',
  children: [
    child(
      {
        tag: 'CollidableShape',
        def: 'postShape',
        children: [
          child(
            {
              tag: 'Shape',
              def: 'postLook',
              children: [child({ tag: 'Box', def: 'postBox', attributes: 'size="0.1 0.1 0.1"' })],
            },
            'shape',
          ),
        ],
      },
      'geometry',
    ),
  ],
};
const SPACE: Node = {
  tag: 'CollisionSpace',
  def: 'space',
  children: [child('ballShape', 'collidables'), child('armShape', 'collidables')],
};
const COLLIDER: Node = {
  tag: 'CollisionCollection',
  def: 'collider',
  attributes: 'appliedParameters=\'"BOUNCE"\' bounce="0.6"',
  children: [
    child('space', 'collidables'),
    child('offset', 'collidables'),
    child('postShape', 'collidables'),
  ],
};
const COLLECTION: Node = {
  tag: 'RigidBodyCollection',
  def: 'collection',
  children: [
    child(BALL, 'bodies'),
    child(FLOOR, 'bodies'),
    child(ARM, 'bodies'),
    child(POST, 'bodies'),
    child(JOINT, 'joints'),
    child(COLLIDER, 'collider'),
  ],
};
const SENSOR: Node = {
  tag: 'CollisionSensor',
  def: 'sensor',
  children: [child('collider', 'collider')],
};
/** A body by the shortcut, in a Transform. */
const CRATE: Node = {
  tag: 'Transform',
  def: 'crate',
  attributes: 'translation="-5 4 0"',
  children: [
    child({
      tag: 'Shape',
      def: 'crateLook',
      children: [child({ tag: 'Box', def: 'crateBox', attributes: 'size="1 1 1"' })],
    }),
    child({ tag: 'RigidBody', def: 'crateBody', attributes: 'linearVelocity="1 0 0"' }),
  ],
};
const SCENE: Child[] = [
  child(COLLECTION),
  child(SENSOR),
  child('ballShape'),
  child('offset'),
  child('armShape'),
  child(CRATE),
];

/** Every node that is the value of some field, by its DEF, and the fields. */
const nodes = new Map<string, Node>();
const fields = new Map<string, Set<string>>();

function note({ node, field = 'children' }: Child, parent: string): void {
  const def = typeof node === 'string' ? node : node.def;
  const all = fields.get(def) ?? new Set();
  fields.set(def, all.add(`${parent}.${field}`));
  if (typeof node === 'string') return;
  nodes.set(def, node);
  for (const each of node.children ?? []) note(each, node.tag);
}
for (const each of SCENE) note(each, 'Scene');
nodes.set('space', SPACE);
for (const each of SPACE.children!) note(each, SPACE.tag);

/** What stands elsewhere together: none of these stands in another one of its row. */
export const MOVED: readonly (readonly string[])[] = [
  ['collection'],
  ['ball', 'floor', 'arm', 'post', 'joint', 'collider', 'sensor', 'crate'],
  ['ballShape', 'offset', 'armShape', 'postShape', 'space', 'model', 'crateLook', 'crateBody'],
  ['shape', 'floorShape', 'armLook', 'postLook', 'crateBox'],
  ['faces', 'floorLook', 'armBox', 'postBox'],
  ['coord', 'floorBox'],
];

/** All nodes that are the value of a field. */
export const ALL = [...nodes.keys()];

/** The fields of which a node is a value somewhere in the scene. */
export const fieldsOf = (def: string): string[] => [...fields.get(def)!];

function written(
  { node, field }: Child,
  elsewhere: ReadonlySet<string>,
  seen: Set<string>,
): string {
  const def = typeof node === 'string' ? node : node.def;
  const container = field ? ` containerField="${field}"` : '';
  const { tag, attributes = '', children = [] } = nodes.get(def)!;
  if (elsewhere.has(def) || seen.has(def)) return `<${tag} USE="${def}"${container}></${tag}>`;
  seen.add(def);
  const inner = children.map((each) => written(each, elsewhere, seen)).join('');
  return `<${tag} DEF="${def}"${container} ${attributes}>${inner}</${tag}>`;
}

/** The scene, and the nodes `moved` as they are to stand elsewhere; all that is in them goes along. */
export function sceneWithout(moved: readonly string[]): { scene: string; kept: string[] } {
  const seen = new Set<string>();
  const kept = moved.map((def) => {
    const others = new Set(moved.filter((other) => other !== def));
    return written(child(nodes.get(def)!), others, seen);
  });
  const scene = SCENE.map((each) => written(each, new Set(moved), seen)).join('');
  return { scene, kept };
}

const inMetadata = (kept: string[]): string =>
  `<WorldInfo title="t"><MetadataSet name="m" reference="r">${kept.map(asValue).join('')}</MetadataSet></WorldInfo>`;

const asValue = (node: string): string => node.replace(/^<(\w+)/, '<$1 containerField="value"');

const inGroup = (kept: string[]): string => `<Group>${kept.join('')}</Group>`;

const inScript = (kept: string[]): string =>
  `<Script DEF="script"><field name="kept" type="MFNode" accessType="initializeOnly">${kept.join('')}</field></Script>`;

/** Where nodes may stand: the markup of a scene from its own and theirs. */
export const PLACES: Record<string, (scene: string, kept: string[]) => string> = {
  'a Group before': (scene, kept) => inGroup(kept) + scene,
  'a Group after': (scene, kept) => scene + inGroup(kept),
  metadata: (scene, kept) => inMetadata(kept) + scene,
  'metadata after': (scene, kept) => scene + inMetadata(kept),
  'metadata, deep': (scene, kept) =>
    `<Group><MetadataSet name="a" containerField="metadata"><MetadataSet name="b" containerField="value"><Group containerField="value">${inGroup(kept)}</Group></MetadataSet></MetadataSet></Group>${scene}`,
  'a Switch that chooses nothing': (scene, kept) =>
    `<Switch whichChoice="-1">${inGroup(kept)}</Switch>${scene}`,
  'a LOD that shows another level': (scene, kept) =>
    `<LOD range="1">${inGroup(kept)}<Group></Group></LOD>${scene}`,
  'a prototype of all': (scene, kept) =>
    `<ProtoDeclare name="All"><ProtoBody><Group>${inMetadata(kept)}${scene}</Group></ProtoBody></ProtoDeclare><ProtoInstance name="All" DEF="all"></ProtoInstance>`,
  'a Group of a file': (scene, kept) => inFile(inGroup(kept) + scene),
  'metadata of a file': (scene, kept) => inFile(inMetadata(kept) + scene),
  'the field of a Script': (scene, kept) => inFile(inScript(kept) + scene),
  'the field of a Script after': (scene, kept) => inFile(scene + inScript(kept)),
  'a file that exports them': (scene, kept) => imported(inGroup(kept)) + scene,
  'a file that exports them, after': (scene, kept) => scene + imported(inGroup(kept)),
  'the metadata of a file that exports them': (scene, kept) => imported(inMetadata(kept)) + scene,
  'another collection after': (scene, kept) => scene + kept.map(inAnotherCollection).join(''),
};

const inFile = (content: string): string => `<inline DEF="file" url="${fileOf(content)}"></inline>`;

const fileOf = (content: string): string =>
  URL.createObjectURL(
    new Blob([`<X3D profile="Full" version="4.0"><Scene>${content}</Scene></X3D>`], {
      type: 'model/x3d+xml',
    }),
  );

function imported(content: string): string {
  const names = [...content.matchAll(/DEF="(\w+)"/g)].map(([, name]) => name);
  const out = names.map((name) => `<EXPORT localDEF="${name}" AS="given-${name}"/>`);
  const into = names.map(
    (name) => `<import inlineDEF="file" importedDEF="given-${name}" AS="${name}"></import>`,
  );
  return inFile(content + out.join('')) + into.join('');
}

/** Where a node of this kind may stand in another collection. */
function inAnotherCollection(node: string): string {
  const [, tag] = node.match(/^<(\w+)/)!;
  const hold = HOLDERS.find(([tags]) => tags.test(tag))?.[1];
  return hold?.(node) ?? inGroup([node]);
}

const inBody = (shape: string): string =>
  `<RigidBodyCollection><RigidBody fixed="true" position="90 0 0">${shape}</RigidBody></RigidBodyCollection>`;
const HOLDERS: [RegExp, (node: string) => string][] = [
  [
    /^(RigidBody|BallJoint|CollisionCollection)$/,
    (node) => `<RigidBodyCollection>${node}</RigidBodyCollection>`,
  ],
  [
    /^(CollidableShape|CollidableOffset|CollisionSpace)$/,
    (node) => `<CollisionCollection enabled="false">${node}</CollisionCollection>`,
  ],
  [/^Shape$/, (node) => inBody(`<CollidableShape>${node}</CollidableShape>`)],
  [
    /^(Box|Sphere|IndexedFaceSet)$/,
    (node) => inBody(`<CollidableShape><Shape>${node}</Shape></CollidableShape>`),
  ],
  [
    /^Coordinate$/,
    (node) =>
      inBody(
        `<CollidableShape><Shape><IndexedFaceSet coordIndex="0 1 2 -1 0 3 1 -1 1 3 2 -1 2 3 0 -1">${node}</IndexedFaceSet></Shape></CollidableShape>`,
      ),
  ],
];

/** Kinds of node that live in one place: a second collection is told that it goes without. */
const isOwned = (def: string): boolean =>
  /^(RigidBody|BallJoint|CollisionCollection)$/.test(nodes.get(def)!.tag) && def !== 'crateBody';

/** How often that is told, of the nodes that stand in another collection after. */
export const ownedAmong = (moved: readonly string[]): number => moved.filter(isOwned).length;
