import { existsSync } from 'node:fs';
import type { StorybookConfig } from '@storybook/web-components-vite';

/** Served as they are. The stories show the built library, the file that a page would load. */
const staticDirs = [
  { from: '../node_modules/x3dom', to: '/x3dom' },
  { from: '../dist', to: '/dist' },
  { from: '../stories/assets', to: '/assets' },
];

const config: StorybookConfig = {
  framework: '@storybook/web-components-vite',
  stories: ['../stories/**/*.stories.ts'],
  staticDirs: staticDirs.filter(({ from }) => existsSync(new URL(from, import.meta.url))),
  core: { disableTelemetry: true, disableWhatsNewNotifications: true },
};

export default config;
