// The rooms of each tree from the bottom up: what lies in one imports only from it and from those before it, types
// included. ESLint forbids the rest (eslint.config.js); `npm run rooms` shows how things stand.

export const trees = {
  core: {
    root: 'physics-core',
    rooms: [
      'fields',
      'base',
      'engine',
      'shapes',
      'dynamics',
      'effects',
      'nodes',
      'world',
      'accuracy',
    ],
    circles: [],
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
      'plans',
      'outward',
      'scene',
      'page',
    ],
    circles: [],
  },
};

/** The room of the files that lie in a tree's root: they may import all others. */
export const TOP = '(root)';
