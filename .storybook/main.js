import { existsSync } from 'node:fs';
import { wasmAsText } from '../tools/rollup-plugins.js';

/**
 * Served as they are, at the addresses they have in the repository. The stories show the built library, the file
 * that a page would load; they show the pages of stories/pages, which name their files from there; and they lead on to
 * the report of the accuracy lab, whose pages tools/stories.js draws.
 */
const FOLDERS = [
  'node_modules/x3dom',
  'dist',
  'stories/assets',
  'styles',
  'stories/pages',
  'site/kit',
  'lab/report',
];

const staticDirs = FOLDERS.map((folder) => ({ from: `../${folder}`, to: `/${folder}` }));

/** @type {import('@storybook/web-components-vite').StorybookConfig} */
const config = {
  framework: '@storybook/web-components-vite',
  addons: ['@storybook/addon-docs'],
  stories: ['../stories/**/*.stories.ts'],
  staticDirs: staticDirs.filter(({ from }) => existsSync(new URL(from, import.meta.url))),
  core: { disableTelemetry: true, disableWhatsNewNotifications: true },
  // Nothing of these works on a 3D scene, or no story uses it.
  features: {
    actions: false,
    backgrounds: false,
    interactions: false,
    measure: false,
    outline: false,
  },
  // Reference pages read the tables of the sources, which name the module that the library's own build makes.
  viteFinal: (vite) => ({ ...vite, plugins: [...(vite.plugins ?? []), wasmAsText()] }),
};

export default config;
