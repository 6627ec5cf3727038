// The rooms of each tree from the bottom up: what lies in one imports only from it and from those before it, types
// included. ESLint forbids the rest (eslint.config.js); `npm run rooms` shows how things stand.

export const trees = {
  core: {
    root: 'physics-core',
    rooms: [
      'fields',
      'base',
      'solver',
      'engine',
      'shapes',
      'dynamics',
      'effects',
      'nodes',
      'world',
      'accuracy',
      'timeline',
      'thread',
      'face',
    ],
    circles: [
      // A body is mutually its parts: each part acts on the body that it is a part of.
      [
        'body-build',
        'body-commands',
        'body-geometry',
        'body-grip',
        'body-loads',
        'body-mass',
        'body-motion',
        'body-object',
        'body-presence',
        'body-shape',
        'body',
      ].map((part) => `nodes/body/${part}.ts`),
      // Types alone: a world has nodes, a node a world, and both have events and fields.
      ['events', 'fields', 'nodes', 'values', 'world'].map((part) => `face/${part}.ts`),
    ],
  },
  bridge: {
    root: 'elements/bridge',
    rooms: [
      'base',
      'words',
      'geometry',
      'x3dom',
      'scopes',
      'nodes',
      'document',
      'drawing',
      'batch',
      'plans',
      'outward',
      'matter',
      'particles',
      'water',
      'ropes',
      'deformables',
      'scene',
      'page',
    ],
    circles: [],
  },
};

/** The room of the files that lie in a tree's root: they may import all others. */
export const TOP = '(root)';
