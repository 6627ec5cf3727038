import type { Decorator, Preview } from '@storybook/web-components-vite';

/** x3dom reads a page when it loads; a scene that a story puts in later has to be pointed out to it. */
const readNewScenes: Decorator = (story) => {
  const { x3dom } = globalThis as { x3dom?: { reload(): void } };
  queueMicrotask(() => x3dom?.reload());
  return story();
};

const preview: Preview = {
  decorators: [readNewScenes],
  parameters: { layout: 'fullscreen' },
};

export default preview;
