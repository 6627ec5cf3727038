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

/** What may stand elsewhere, of all that there is. */
export const MOVABLE = [...nodes.keys()];

/** The fields of which a node is a value somewhere in the scene. */
export const fieldsOf = (def: string): string[] => [...fields.get(def)!];

/** Nodes that stand elsewhere, by DEF. */
type Elsewhere = ReadonlySet<string>;

function written({ node, field }: Child, elsewhere: Elsewhere, seen: Set<string>): string {
  const def = typeof node === 'string' ? node : node.def;
  const container = field ? ` containerField="${field}"` : '';
  const { tag, attributes = '', children = [] } = nodes.get(def)!;
  if (elsewhere.has(def) || seen.has(def)) return `<${tag} USE="${def}"${container}></${tag}>`;
  seen.add(def);
  const inner = children.map((each) => written(each, elsewhere, seen)).join('');
  return `<${tag} DEF="${def}"${container} ${attributes}>${inner}</${tag}>`;
}

/** The scene, and the node `moved` as it is to stand elsewhere; all that is in it goes along. */
export function sceneWithout(moved: string | undefined): { scene: string; node: string } {
  const elsewhere = new Set(moved ? [moved] : []);
  const seen = new Set<string>();
  const node = moved ? written(child(nodes.get(moved)!), new Set(), seen) : '';
  const scene = SCENE.map((each) => written(each, elsewhere, seen)).join('');
  return { scene, node };
}

const inMetadata = (node: string): string =>
  `<WorldInfo title="t"><MetadataSet name="m" reference="r">${withField(node, 'value')}</MetadataSet></WorldInfo>`;

const withField = (node: string, field: string): string =>
  node.replace(/^<(\w+)/, `<$1 containerField="${field}"`);

/** Where the node may stand: the markup of a scene from its own and the node's. */
export const PLACES: Record<string, (scene: string, node: string) => string> = {
  'a Group before': (scene, node) => `<Group>${node}</Group>${scene}`,
  'a Group after': (scene, node) => `${scene}<Group>${node}</Group>`,
  metadata: (scene, node) => inMetadata(node) + scene,
  'metadata after': (scene, node) => scene + inMetadata(node),
  'metadata, deep': (scene, node) =>
    `<Group><MetadataSet name="a" containerField="metadata"><MetadataSet name="b" containerField="value"><Group containerField="value"><Group>${node}</Group></Group></MetadataSet></MetadataSet></Group>${scene}`,
  'a Switch that chooses nothing': (scene, node) =>
    `<Switch whichChoice="-1"><Group>${node}</Group></Switch>${scene}`,
  'a LOD that shows another level': (scene, node) =>
    `<LOD range="1"><Group>${node}</Group><Group></Group></LOD>${scene}`,
  'a prototype of all': (scene, node) =>
    `<ProtoDeclare name="All"><ProtoBody><Group>${inMetadata(node)}${scene}</Group></ProtoBody></ProtoDeclare><ProtoInstance name="All" DEF="all"></ProtoInstance>`,
  'a Group of a file': (scene, node) => inFile(`<Group>${node}</Group>${scene}`),
  'metadata of a file': (scene, node) => inFile(inMetadata(node) + scene),
  'the field of a Script': (scene, node) =>
    inFile(
      `<Script DEF="script"><field name="kept" type="SFNode" accessType="initializeOnly">${node}</field></Script>${scene}`,
    ),
  'the field of a Script after': (scene, node) =>
    inFile(
      `${scene}<Script DEF="script"><field name="kept" type="SFNode" accessType="initializeOnly">${node}</field></Script>`,
    ),
  'a file that exports it': (scene, node) => imported(node, `<Group>${node}</Group>`) + scene,
  'a file that exports it, after': (scene, node) =>
    scene + imported(node, `<Group>${node}</Group>`),
  'the metadata of a file that exports it': (scene, node) =>
    imported(node, inMetadata(node)) + scene,
};

const inFile = (content: string): string => `<inline DEF="file" url="${fileOf(content)}"></inline>`;

const fileOf = (content: string): string =>
  URL.createObjectURL(
    new Blob([`<X3D profile="Full" version="4.0"><Scene>${content}</Scene></X3D>`], {
      type: 'model/x3d+xml',
    }),
  );

function imported(node: string, content: string): string {
  const [, name] = node.match(/DEF="(\w+)"/)!;
  return `${inFile(`${content}<EXPORT localDEF="${name}" AS="given"/>`)}<import inlineDEF="file" importedDEF="given" AS="${name}"></import>`;
}

/** Where a node of this kind may stand in another collection; after the scene, which has it first. */
export function inAnotherCollection(scene: string, node: string): string {
  const [, tag] = node.match(/^<(\w+)/)!;
  const hold = HOLDERS.find(([tags]) => tags.test(tag))?.[1];
  return scene + (hold?.(node) ?? `<Group>${node}</Group>`);
}

const inBody = (shape: string): string =>
  `<RigidBodyCollection><RigidBody fixed="true" position="90 0 0">${shape}</RigidBody></RigidBodyCollection>`;
const HOLDERS: [RegExp, (node: string) => string][] = [
  [
    /^(RigidBody|BallJoint|CollisionCollection)$/,
    (node) => `<RigidBodyCollection DEF="second">${node}</RigidBodyCollection>`,
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

/** Kinds of node that live in one place: the second collection is told that it goes without. */
export const isOwned = (def: string): boolean =>
  /^(RigidBody|BallJoint|CollisionCollection)$/.test(nodes.get(def)!.tag) && def !== 'crateBody';
