import js from '@eslint/js';
import tseslint from 'typescript-eslint';
import { trees } from './tools/check/rooms.config.js';

// The fence between the rooms (who may import and name what). Each rule below replaces the one before it for
// the same file, so every room lists all that holds for it, from these parts.

const imports = (...patterns) => ({ 'no-restricted-imports': ['error', { patterns }] });
const globals = (...names) => ({ 'no-restricted-globals': ['error', ...names] });
const syntax = (...selectors) => ({ 'no-restricted-syntax': ['error', ...selectors] });

const noLab = { regex: '(^|/)lab/', message: 'Nothing imports lab/.' };
const noTest = {
  regex: '(^|(?<!tools)/)test/',
  message: 'What tests and others share lies in references/.',
};
const noReferences = {
  regex: '(^|/)references/',
  message: 'references/ is what the library is measured by.',
};
const noElements = { regex: '(^|/)elements/', message: 'physics-core knows no elements.' };
const noPage = {
  regex: '^(lit|@lit|x3dom)(/|$)',
  message: 'physics-core knows neither lit nor x3dom.',
};
const noX3domImport = { regex: '^x3dom(/|$)', message: 'x3dom is a classic script of the page.' };
const noEngine = {
  regex: '(^|/)engine/|^ammojs-typed',
  message: 'Bullet stays in physics-core/engine, nodes, shapes and effects: use node handles.',
};
const noOffsets = {
  regex: '(^|/)engine/offsets\\.js$',
  message:
    'Only physics-core/engine reads and writes the heap: it has words for what stands there.',
};

const DOM = ['window', 'document', 'HTMLElement', 'Element', 'customElements'].map((name) => ({
  name,
  message: 'physics-core knows no DOM.',
}));
const noDomType = {
  selector: 'TSTypeReference[typeName.name=/^(HTML\\w*|Document|Window)$/]',
  message: 'physics-core knows no DOM.',
};
const x3dom = { name: 'x3dom', message: 'Only elements/bridge says x3dom.' };

const noAmmo = { selector: 'Identifier[name=/Ammo/]', message: 'Use node handles, not Ammo.' };
const noHeap = { selector: 'Identifier[name=/^HEAP[UF]?\\d/]', message: noOffsets.message };
/** Whose last bits differ between browsers. */
const INEXACT = 'sin cos tan asin acos atan atan2 exp expm1 log hypot cbrt pow';
const noInexact = INEXACT.split(' ').map((property) => ({
  object: 'Math',
  property,
  message: 'Bits differ between browsers: physics-core/base/exact has its like.',
}));
/** In rooms that run in every step. */
const STEPS = ['base', 'solver', 'engine', 'dynamics', 'effects'];
const noTakenApart = [
  'VariableDeclarator[id.type="ArrayPattern"][init.type="ArrayExpression"]',
  'AssignmentExpression[left.type="ArrayPattern"][right.type="ArrayExpression"]',
].map((selector) => ({
  selector,
  message:
    'WebKit and Firefox make the array, which doubles what a contact costs: one name a line.',
}));
/** `globalThis.x3dom` is the same global. */
const noX3domProperty = {
  selector: 'MemberExpression[property.name="x3dom"]',
  message: x3dom.message,
};
const noOnly = {
  selector:
    'MemberExpression[object.name=/^(describe|it|test|suite|context)$/][property.name="only"]',
  message: 'It would switch off all other tests.',
};

// The rooms of a tree (tools/check/rooms.config.js): each may import itself and those below, types included.

/** What holds in a room beside its place in the order. */
const held = {
  core: (room) => ({
    imports: [
      ...[noElements, noPage, noReferences, noTest, noLab],
      ...(room === 'engine' ? [] : [noOffsets]),
    ],
    syntax: [
      ...[noX3domProperty, noDomType],
      ...(room === 'engine' ? [] : [noHeap]),
      ...(room === 'accuracy' ? [noAmmo] : []),
      ...(STEPS.includes(room) ? noTakenApart : []),
    ],
  }),
  bridge: () => ({
    imports: [noEngine, noX3domImport, noLab],
    syntax: [noAmmo],
  }),
};

/** Imports of rooms above, from files that lie `depth` folders below the tree's root. */
function upward(tree, room, depth) {
  const { rooms } = trees[tree];
  const above = rooms.slice(rooms.indexOf(room) + 1);
  const root = `^(\\.\\./){${depth}}`;
  // Files in the root are the top room.
  const regex = [...above.map((name) => `${root}${name}/`), `${root}[^./]+\\.js$`].join('|');
  const message = `${room} imports no room above it (tools/check/rooms.config.js).`;
  // `import('…')`, of values and of types, is no import statement. A selector takes no slash: 2f in ASCII.
  const named = `[value=/${regex.replaceAll('/', '\\x2f')}/]`;
  return {
    imports: { regex, message },
    syntax: ['ImportExpression > Literal', 'TSImportType Literal'].map((node) => ({
      selector: `${node}${named}`,
      message,
    })),
  };
}

/** The rules of each room of a tree, for files in its folder and in folders of that. */
const fences = (tree) =>
  trees[tree].rooms.flatMap((room) =>
    [1, 2].map((depth) => {
      const up = upward(tree, room, depth);
      const all = held[tree](room);
      return {
        files: [`${trees[tree].root}/${room}/${'*/'.repeat(depth - 1)}*.ts`],
        rules: {
          ...imports(...all.imports, up.imports),
          ...syntax(...all.syntax, ...up.syntax),
        },
      };
    }),
  );

export default tseslint.config(
  {
    ignores: [
      '**/dist/',
      'dist-next/',
      '**/.next/',
      '**/.angular/',
      '**/next-env.d.ts',
      'storybook-static/',
      'storybook-static-next/',
      'site-static/',
      'site/public/',
      'site/.vitepress/cache/',
      'coverage/',
      'test-bundles/',
    ],
  },
  js.configs.recommended,
  ...tseslint.configs.recommended,
  {
    rules: {
      '@typescript-eslint/no-unused-vars': [
        'error',
        { argsIgnorePattern: '^_', varsIgnorePattern: '^_', caughtErrors: 'none' },
      ],
    },
  },
  {
    files: ['**/*.js'],
    languageOptions: {
      globals: Object.fromEntries(
        [
          'console',
          'process',
          'setImmediate',
          'setInterval',
          'setTimeout',
          'clearTimeout',
          'URL',
        ].map((name) => [name, 'readonly']),
      ),
    },
  },

  {
    files: ['examples/plain/*.js', 'examples/starter/src/*.js'],
    languageOptions: { globals: { document: 'readonly' } },
  },

  // The rooms.
  {
    files: ['physics-core/**/*.ts'],
    ignores: ['physics-core/base/exact/*.ts'],
    rules: { 'no-restricted-properties': ['error', ...noInexact] },
  },
  {
    files: ['physics-core/**/*.ts'],
    rules: {
      ...imports(noElements, noPage, noReferences, noTest, noLab),
      ...globals(...DOM, x3dom),
      ...syntax(noX3domProperty, noDomType),
    },
  },
  {
    files: ['elements/**/*.ts'],
    rules: {
      ...imports(noEngine, noX3domImport, noReferences, noTest, noLab),
      ...globals(x3dom),
      ...syntax(noAmmo, noX3domProperty),
    },
  },
  {
    files: ['elements/bridge/**/*.ts'],
    rules: { ...globals(), ...syntax(noAmmo) },
  },
  ...fences('core'),
  ...fences('bridge'),
  {
    // A classic page has the core and the bridge already when it loads a view.
    files: ['elements/ui/*/**/*.ts'],
    rules: {
      '@typescript-eslint/no-restricted-imports': [
        'error',
        {
          patterns: [
            {
              regex: '(^|/)(physics-core|bridge)/',
              allowTypeImports: true,
              message: 'Only types: views have the rest already.',
            },
          ],
        },
      ],
    },
  },
  {
    files: ['stories/**/*.ts', 'site/**/*.ts', 'site/.vitepress/**/*.ts'],
    rules: { ...imports(noLab), ...globals(x3dom), ...syntax(noX3domProperty) },
  },
  {
    // Offers x3dom's own nodes and fields to who writes.
    files: ['site/playground/scene/x3dom-nodes.ts'],
    rules: { 'no-restricted-syntax': 'off' },
  },
  {
    files: ['references/**/*.ts'],
    rules: {
      ...imports(noElements, noPage, noEngine, noTest, noLab),
      ...globals(...DOM, x3dom),
      ...syntax(noAmmo),
    },
  },
  {
    files: ['lab/**/*.ts'],
    rules: imports(noTest),
  },
  {
    // What other libraries have in a page has no types.
    files: ['lab/page/in-page/*.ts', 'lab/particles/in-page/*.ts'],
    rules: { '@typescript-eslint/no-explicit-any': 'off' },
  },
  {
    files: ['test/**/*.ts'],
    rules: {
      ...imports(noLab),
      ...syntax(noOnly),
      // chai: expect(x).to.be.true
      '@typescript-eslint/no-unused-expressions': 'off',
      // Tests reach into pages and hand over what no type allows.
      '@typescript-eslint/no-explicit-any': 'off',
    },
  },
  {
    // The lab is measured too.
    files: [
      'test/lab/**/*.ts',
      'test/soaks/lab/**/*.ts',
      'test/stability/**/*.ts',
      'test/browser/stability/**/*.ts',
    ],
    rules: { 'no-restricted-imports': 'off' },
  },
);
