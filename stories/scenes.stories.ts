import type { Meta, StoryObj } from '@storybook/web-components-vite';
import chain from './pages/growing-chain.html?raw';
import pendulum from './pages/pendulum.html?raw';
import pendulumAndMotor from './pages/pendulum-and-motor.html?raw';
import room from './pages/room-of-boxes.html?raw';
import { framed, page } from './page.js';

const meta: Meta = { title: 'Scenes' };
export default meta;

export const Pendulum: StoryObj = { render: () => page(pendulum) };
export const PendulumXhtml: StoryObj = {
  name: 'Pendulum, XHTML',
  render: () => framed('pendulum.xhtml'),
};

export const PendulumAndMotor: StoryObj = { render: () => page(pendulumAndMotor) };
export const PendulumAndMotorXhtml: StoryObj = {
  name: 'Pendulum And Motor, XHTML',
  render: () => framed('pendulum-and-motor.xhtml'),
};

export const RoomOfBoxes: StoryObj = { render: () => page(room) };
export const RoomOfBoxesXhtml: StoryObj = {
  name: 'Room Of Boxes, XHTML',
  render: () => framed('room-of-boxes.xhtml'),
};

export const GrowingChain: StoryObj = { render: () => page(chain) };
export const GrowingChainXhtml: StoryObj = {
  name: 'Growing Chain, XHTML',
  render: () => framed('growing-chain.xhtml'),
};
