import type { ArgTypesEnhancer } from 'storybook/internal/types';
import { nodeTypes } from '../../physics-core/nodes/index.js';

/** A control named as a field of its node says what the node's table says, unless the story says more. */
export const describeArgs: ArgTypesEnhancer = ({ title, argTypes }) => {
  const fields = nodeTypes[title.split('/').at(-1)!]?.fields;
  return Object.fromEntries(
    Object.entries(argTypes).map(([name, arg]) => [
      name,
      { ...arg, description: arg.description ?? fields?.[name]?.doc },
    ]),
  );
};
