import type { Meta, StoryObj } from '@storybook/web-components-vite';
import chain from './pages/growing-chain.html?raw';
import pendulum from './pages/pendulum.html?raw';
import pendulumAndMotor from './pages/pendulum-and-motor.html?raw';
import room from './pages/room-of-boxes.html?raw';
import { page } from './page.js';

const meta: Meta = { title: 'Scenes' };
export default meta;

export const Pendulum: StoryObj = { render: () => page(pendulum) };
export const PendulumAndMotor: StoryObj = { render: () => page(pendulumAndMotor) };
export const RoomOfBoxes: StoryObj = { render: () => page(room) };
export const GrowingChain: StoryObj = { render: () => page(chain) };
