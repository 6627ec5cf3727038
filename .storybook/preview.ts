import type { Preview } from '@storybook/web-components-vite';
import { describeArgs } from '../stories/reference/describe-args.js';

const preview: Preview = {
  argTypesEnhancers: [describeArgs],
  parameters: {
    layout: 'fullscreen',
    // With what each control does.
    controls: { expanded: true },
    // The first is what opens.
    options: {
      storySort: {
        order: [
          'Start here',
          'Scenes',
          'Dragging',
          'Drawing',
          'In a worker',
          'Accuracy',
          'Shortcuts',
          'Looking in',
          'Nodes',
          'In XHTML',
        ],
      },
    },
    docs: {
      // Fetched with the first reference page; a story needs none of it.
      renderer: async () => (await import('../stories/reference/renderer.js')).renderer,
    },
  },
};

export default preview;
