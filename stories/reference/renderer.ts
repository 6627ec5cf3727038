// Storybook's docs pages, without the React that it brings for them.
import type { WebComponentsRenderer } from '@storybook/web-components-vite';
import { render, type TemplateResult } from 'lit';
import type { DocsContextProps } from 'storybook/internal/types';
import { referencePage } from './page.js';

export const renderer = {
  async render(
    context: DocsContextProps<WebComponentsRenderer>,
    _parameters: unknown,
    element: HTMLElement,
  ): Promise<void> {
    const [example] = context.componentStories();
    if (!example) return;
    const story = example.unboundStoryFn({
      ...context.getStoryContext(example),
      args: example.initialArgs,
    } as never);
    const { code } = example.parameters as { code?: string };
    const page = referencePage(example.title, example.id, story as TemplateResult, code);
    render(page, element);
  },
  unmount(element: HTMLElement): void {
    render(null, element);
  },
};
