import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { framed } from './page.js';

/** The same scenes in X3D's own tags. */
const meta: Meta = { title: 'In XHTML/Scenes' };
export default meta;

export const Pendulum: StoryObj = { render: () => framed('pendulum.xhtml') };
export const PendulumAndMotor: StoryObj = { render: () => framed('pendulum-and-motor.xhtml') };
export const RoomOfBoxes: StoryObj = { render: () => framed('room-of-boxes.xhtml') };
export const GrowingChain: StoryObj = { render: () => framed('growing-chain.xhtml') };
