import type { SvelteHTMLElements } from 'svelte/elements';
import 'x3d-physics/svelte';

type Body = SvelteHTMLElements['x3d-rigid-body'];
export const body: Body = { mass: 2, oncollisionstart: ({ detail }) => detail.other };
// @ts-expect-error There is no such attribute.
export const misspelt: Body = { maas: 2 };
