import type { PageAt } from '../page/asked.js';
import { pagesWith } from '../page/pages.js';
import type { Answer, AskedPages } from '../run/asked-browser.js';
import { formOf } from './forms.js';
import { libraryOf } from './libraries.js';

/** The page of a library in which so many particles are drawn in a form. */
export const pageOf = (library: string, form: string, count: number): PageAt => [
  library,
  `/page?${new URLSearchParams({ library, form, count: String(count) })}`,
];

function systemAt({ pathname, search, searchParams }: URL): Answer | undefined {
  if (pathname !== '/page' && pathname !== '/file') return undefined;
  const library = libraryOf(searchParams.get('library')!);
  const form = formOf(searchParams.get('form')!);
  const count = Number(searchParams.get('count'));
  if (pathname === '/file') return ['model/x3d+xml', library.file!(form, count)];
  return ['text/html; charset=utf-8', library.page(form, count, `/page${search}`)];
}

export const makePages = (): Promise<AskedPages> =>
  pagesWith(
    {
      '/hooks.js': 'lab/particles/in-page/hooks.ts',
      '/babylon.js': 'lab/particles/in-page/babylon.ts',
    },
    systemAt,
  );
