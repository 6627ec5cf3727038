/** @jsxImportSource react */
import 'x3d-physics/react';

export const body = <x3d-rigid-body mass={2} oncollisionstart={({ detail }) => detail.other} />;
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;
