import { addons } from 'storybook/manager-api';
import { create } from 'storybook/theming/create';

const { matches: dark } = matchMedia('(prefers-color-scheme: dark)');

addons.setConfig({
  theme: create({ base: dark ? 'dark' : 'light', brandTitle: 'x3d-physics', brandUrl: './' }),
  layoutCustomisations: {
    // Only beside a story that has controls: an empty panel would take its place from the scene.
    showPanel({ index, storyId }, shown) {
      const entry = index?.[storyId];
      const hasControls = entry?.type === 'story' && Object.keys(entry.argTypes ?? {}).length > 0;
      return shown && hasControls;
    },
  },
});
