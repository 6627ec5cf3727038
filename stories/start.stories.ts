import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { startPage } from './start/page.js';

const meta: Meta = { title: 'Start here' };
export default meta;

/** By its title's very name it stands in the menu without a folder around it. */
export const StartHere: StoryObj = { name: 'Start here', render: startPage };
