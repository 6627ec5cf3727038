import type { Meta, StoryObj } from '@storybook/web-components-vite';
import chain from '../test/pages/scene4.html?raw';
import pendulum from '../test/pages/scene1.html?raw';
import pendulumAndMotor from '../test/pages/scene2.html?raw';
import room from '../test/pages/scene3.html?raw';
import { framed, page } from './page.js';

const meta: Meta = { title: 'Scenes' };
export default meta;

export const Pendulum: StoryObj = { render: () => page(pendulum) };
export const PendulumXhtml: StoryObj = {
  name: 'Pendulum, XHTML',
  render: () => framed('scene1.xhtml'),
};

export const PendulumAndMotor: StoryObj = { render: () => page(pendulumAndMotor) };
export const PendulumAndMotorXhtml: StoryObj = {
  name: 'Pendulum And Motor, XHTML',
  render: () => framed('scene2.xhtml'),
};

export const RoomOfBoxes: StoryObj = { render: () => page(room) };
export const RoomOfBoxesXhtml: StoryObj = {
  name: 'Room Of Boxes, XHTML',
  render: () => framed('scene3.xhtml'),
};

export const GrowingChain: StoryObj = { render: () => page(chain) };
export const GrowingChainXhtml: StoryObj = {
  name: 'Growing Chain, XHTML',
  render: () => framed('scene4.xhtml'),
};
