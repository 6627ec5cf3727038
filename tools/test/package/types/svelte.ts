import type { SvelteHTMLElements } from 'svelte/elements';
import 'x3d-physics/svelte';

type Body = SvelteHTMLElements['x3d-rigid-body'];
export const body: Body = {
  mass: 2,
  oncollisionstart: ({ detail }) => detail.other,
  onclick: ({ currentTarget }) => currentTarget.applyImpulse([0, 1, 0]),
  title: 'The upper one',
  style: 'color: red',
  class: 'body',
  id: 'upper',
  'aria-label': 'upper',
  'data-testid': 'upper',
};
// @ts-expect-error There is no such attribute.
export const misspelt: Body = { maas: 2 };
export const joint: SvelteHTMLElements['x3d-ball-joint'] = {
  body1: 'upper',
  anchorPoint: [0, 3, 0],
};
export const box: SvelteHTMLElements['box'] = { size: '1 1 1' };
export const place: SvelteHTMLElements['transform'] = { translation: [0, 1, 0], id: 'place' };
// @ts-expect-error A material has no such field.
export const paint: SvelteHTMLElements['material'] = { colour: '1 0 0' };
