// Where the first page leads on to. test/stories/links.test.ts holds that all of it is there.
import { allTypes } from '../../physics-core/all-types.js';

export interface Link {
  text: string;
  /** A story's or a reference page's id, as addresses have it; or a file that is served beside the stories. */
  to: string;
}

export interface Room {
  title: string;
  links: readonly Link[];
}

export const ROOMS: readonly Room[] = [
  {
    title: 'Scenes',
    links: [
      { text: 'Pendulum', to: 'scenes--pendulum' },
      { text: 'Pendulum and motor', to: 'scenes--pendulum-and-motor' },
      { text: 'Room of boxes', to: 'scenes--room-of-boxes' },
      { text: 'Growing chain', to: 'scenes--growing-chain' },
    ],
  },
  {
    title: 'Dragging',
    links: [
      { text: 'A heap of boxes', to: 'dragging--heap' },
      { text: 'Three ways to be held', to: 'dragging--modes' },
      { text: 'By keyboard', to: 'dragging--keyboard' },
    ],
  },
  {
    title: 'Editing while it runs',
    links: [
      { text: 'A thrown box', to: 'nodes-rigidbody--rigid-body' },
      { text: 'A door and its stops', to: 'nodes-singleaxishingejoint--single-axis-hinge-joint' },
      { text: 'A conveyor', to: 'nodes-collisioncollection--surface-speed' },
    ],
  },
  {
    title: 'Looking in',
    links: [
      { text: 'Monitor', to: 'looking-in--monitor' },
      { text: 'Debug drawing', to: 'looking-in--debug-drawing' },
      { text: 'Events', to: 'looking-in--events' },
    ],
  },
  {
    title: 'Drawing',
    links: [{ text: 'Two thousand bodies', to: 'drawing--two-thousand-bodies' }],
  },
  {
    title: 'Accuracy',
    links: [
      { text: 'Beside the reference', to: 'accuracy--beside-reference' },
      { text: 'Measured in a scene', to: 'accuracy--chart' },
      { text: 'The finest that fits', to: 'accuracy--auto' },
      { text: 'The lab: other engines beside it', to: 'lab/report/index.html' },
    ],
  },
];

/** In the documentation site, which has the stories in a folder of its own. */
const SITE: Room = {
  title: 'Documentation',
  links: [
    { text: 'What it is', to: '../index.html' },
    { text: 'Which file do I take', to: '../guide/which-file.html' },
    { text: 'Recipes', to: '../recipes/door.html' },
    { text: 'Playground', to: '../playground.html' },
  ],
};

/** Where the stories stand in the site, ways back to it. The site itself reads stories without a page. */
export const backFrom = (path = ''): readonly Room[] => (path.includes('/stories/') ? [SITE] : []);

/** One page for each node. */
export const PAGES: readonly Link[] = Object.keys(allTypes).map((name) => ({
  text: name,
  to: `nodes-${name.toLowerCase()}--docs`,
}));

/** What the first example needs beside it. */
export const SCRIPTS: readonly Link[] = [
  { text: 'x3dom.js', to: 'node_modules/x3dom/x3dom.js' },
  { text: 'x3d-physics.single.js', to: 'dist/x3d-physics.single.js' },
];

export const isFile = ({ to }: Link): boolean => to.includes('/');

export function addressOf(link: Link): string {
  if (isFile(link)) return `./${link.to}`;
  return `./?path=/${link.to.endsWith('--docs') ? 'docs' : 'story'}/${link.to}`;
}
