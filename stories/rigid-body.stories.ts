import type { Meta, StoryObj } from '@storybook/web-components-vite';
import { html } from 'lit';
import { ground, scene, shape } from './scene.js';

interface Args {
  mass: number;
  linearVelocity: string;
  angularVelocity: string;
  forces: string;
  fixed: boolean;
  enabled: boolean;
  useGlobalGravity: boolean;
  autoDamp: boolean;
  linearDampingFactor: number;
  angularDampingFactor: number;
}

const meta: Meta<Args> = {
  title: 'Nodes/RigidBody',
  tags: ['autodocs'],
  args: {
    mass: 2,
    linearVelocity: '2.5 2 0',
    angularVelocity: '1 2 -4',
    forces: '',
    fixed: false,
    enabled: true,
    useGlobalGravity: true,
    autoDamp: false,
    linearDampingFactor: 0.5,
    angularDampingFactor: 0.5,
  },
  argTypes: {
    mass: { control: { type: 'number', min: 0.1, step: 0.1 } },
    forces: { control: 'text', description: 'Newtons, summed: try "0 25 0"' },
    linearDampingFactor: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
    angularDampingFactor: { control: { type: 'range', min: 0, max: 1, step: 0.05 } },
  },
  render: (args) =>
    scene(
      'A box is thrown. Each control edits one attribute of the running body.',
      html`
        ${ground}
        <transform translation="-3 3 0">
          ${shape('red', html`<box size="1.2 0.6 0.8"></box>`)}
          <x3d-rigid-body
            mass=${args.mass}
            linearVelocity=${args.linearVelocity}
            angularVelocity=${args.angularVelocity}
            forces=${args.forces}
            fixed=${args.fixed}
            enabled=${args.enabled}
            useGlobalGravity=${args.useGlobalGravity}
            autoDamp=${args.autoDamp}
            linearDampingFactor=${args.linearDampingFactor}
            angularDampingFactor=${args.angularDampingFactor}
          ></x3d-rigid-body>
        </transform>
      `,
    ),
};
export default meta;

export const RigidBody: StoryObj<Args> = {};
