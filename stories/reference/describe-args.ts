import type { ArgTypesEnhancer } from 'storybook/internal/types';
import { allTypes } from '../../physics-core/all-types.js';
import { defaultText } from './default-text.js';

/**
 * A control named as a field of its node says what the node's table says, unless the story says more: what it is, and
 * what holds without it. What is no field has the value that the story starts with.
 */
export const describeArgs: ArgTypesEnhancer = ({ title, argTypes, initialArgs }) => {
  const fields = allTypes[title.split('/').at(-1)!]?.fields;
  return Object.fromEntries(
    Object.keys({ ...initialArgs, ...argTypes }).map((name) => {
      const [arg, field] = [argTypes[name], fields?.[name]];
      const summary = field ? defaultText(field) : String(initialArgs[name]);
      return [
        name,
        {
          ...arg,
          name,
          description: arg?.description ?? field?.doc,
          table: { ...arg?.table, defaultValue: { summary } },
        },
      ];
    }),
  );
};
