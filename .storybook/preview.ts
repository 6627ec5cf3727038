import type { Preview } from '@storybook/web-components-vite';
import { describeArgs } from '../stories/reference/describe-args.js';

const preview: Preview = {
  argTypesEnhancers: [describeArgs],
  parameters: {
    layout: 'fullscreen',
    // With what each control does.
    controls: { expanded: true },
    options: { storySort: { order: ['Scenes', 'Accuracy', 'Shortcuts', 'Looking in', 'Nodes'] } },
    docs: {
      // Fetched with the first reference page; a story needs none of it.
      renderer: async () => (await import('../stories/reference/renderer.js')).renderer,
    },
  },
};

export default preview;
