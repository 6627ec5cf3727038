// What stands where in the site's menu.
import type { DefaultTheme } from 'vitepress';
import { GALLERY } from './gallery.js';

type Item = DefaultTheme.SidebarItem;

const pages = (folder: string, entries: Record<string, string>): Item[] =>
  Object.entries(entries).map(([name, text]) => ({ text, link: `/${folder}/${name}` }));

const START = {
  why: 'Why this, and when not',
  'which-file': 'Which file do I take?',
  markup: 'First steps in markup',
  'cheat-sheet': 'All of it on one page',
  script: 'From a script',
  thread: 'On another thread',
  frameworks: 'Frameworks',
  devtools: 'Live editing in devtools',
  dragging: 'Dragging',
  look: 'The look of these scenes',
  bundlers: 'Bundlers',
  servers: 'Servers and security',
};

const TROUBLE = {
  'not-moving': 'Why doesn’t it move?',
  problems: 'Problem codes',
  'looking-inside': 'Looking inside',
  geometry: 'What collides and is drawn',
  limits: 'What works where',
  migration: 'From other X3D physics',
};

const RECIPES = {
  door: 'A motorised door',
  motor: 'A motor of constant speed',
  lift: 'A lift, a moving platform',
  car: 'A car, and its suspension',
  driving: 'Driving, a camera that follows',
  ragdoll: 'A ragdoll',
  friction: 'Friction and bounce',
  rolling: 'Rolling resistance',
  terrain: 'Terrain',
  gltf: 'A glTF model with a body',
  'jointed-bodies': 'Do bodies on one joint collide?',
  reset: 'Reset and kick',
  throwing: 'Throwing',
  particles: 'Particles: water, snow, dust, smoke',
  water: 'Water: boats, buoys, a bottle, a lock, a jelly',
  ropes: 'Ropes: a lamp, a crane, a swing, a winch',
  cloth: 'Cloth and soft bodies: a flag, a tablecloth, jelly',
  many: 'Many bodies',
  sensors: 'Sensors and triggers',
  counting: 'Counting each marble once',
  tipped: 'Is it tipped over?',
  saving: 'Saving and loading',
  recording: 'Recording and scrubbing',
  vr: 'In VR',
  undo: 'Undo and duplicate in devtools',
};

const INSIDE = {
  edits: 'Edits of a running scene',
  joints: 'Joints that do not stretch',
  contacts: 'Contacts that hold',
  price: 'What a step costs',
  particles: 'Particles',
  'particles-price': 'What particles cost',
  water: 'Water',
  soft: 'Ropes and cloth',
  stability: 'What stays stable',
  effects: 'Effects',
  chunks: 'Files',
  drawing: 'Drawing many bodies',
  pages: 'In real pages',
  conformance: 'Conformance',
  content: 'Files of the world',
};

const REPORT = {
  text: 'The accuracy lab',
  link: '/stories/lab/report/index.html',
  target: '_self',
};

export const sidebar = (nodes: string[]): Item[] => [
  { text: 'Start', items: pages('guide', START) },
  { text: 'Recipes', items: pages('recipes', RECIPES) },
  {
    text: 'Gallery',
    items: [{ text: 'All scenes', link: '/gallery/' }, ...pages('gallery', GALLERY)],
  },
  { text: 'Trouble', items: pages('guide', TROUBLE) },
  {
    text: 'Reference',
    items: nodes.map((text) => ({ text, link: `/reference/${text}` })),
  },
  {
    text: 'How it works',
    items: [
      { text: 'Accuracy', link: '/guide/accuracy' },
      ...pages('docs', INSIDE),
      REPORT,
      { text: 'Changelog', link: '/changelog' },
    ],
  },
];
