import type { Preview } from '@storybook/web-components-vite';

const preview: Preview = {
  parameters: {
    layout: 'fullscreen',
    options: { storySort: { order: ['Scenes', 'Shortcuts', 'Nodes'] } },
  },
};

export default preview;
