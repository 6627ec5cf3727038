/** @jsxImportSource vue */
import 'x3d-physics/vue';

export const body = (
  <x3d-rigid-body mass={2} onCollisionstart={({ detail }) => detail.other} ref="body">
    <x3d-ball-joint body1="upper" />
  </x3d-rigid-body>
);
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;
