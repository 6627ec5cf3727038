import type { GlobalComponents } from 'vue';
import 'x3d-physics/vue';

type Body = InstanceType<GlobalComponents['x3d-rigid-body']>['$props'];
export const body: Body = { mass: 2, onCollisionstart: ({ detail }) => detail.other };
// @ts-expect-error There is no such attribute.
export const misspelt: Body = { maas: 2 };
