/** @jsxImportSource solid-js */
import 'x3d-physics/solid';

export const body = <x3d-rigid-body mass={2} on:collisionstart={({ detail }) => detail.other} />;
// @ts-expect-error There is no such attribute.
export const misspelt = <x3d-rigid-body maas={2} />;
