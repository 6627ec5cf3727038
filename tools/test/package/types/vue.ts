import type { NativeElements } from 'vue';
import 'x3d-physics/vue';

type Body = NativeElements['x3d-rigid-body'];
export const body: Body = {
  mass: 2,
  onCollisionstart: ({ detail }) => detail.other,
  onClick: ({ clientX }) => clientX,
  key: 1,
  title: 'The upper one',
  style: { color: 'red' },
  class: ['body', { fixed: true }],
  id: 'upper',
  'aria-label': 'upper',
};
// @ts-expect-error There is no such attribute.
export const misspelt: Body = { maas: 2 };
export const joint: NativeElements['x3d-ball-joint'] = { body1: 'upper', anchorPoint: [0, 3, 0] };
export const box: NativeElements['box'] = { size: '1 1 1' };
export const place: NativeElements['transform'] = { translation: [0, 1, 0], id: 'place' };
// @ts-expect-error A material has no such field.
export const paint: NativeElements['material'] = { colour: '1 0 0' };
