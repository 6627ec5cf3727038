import { bothSpellings } from '../../forms.js';
import { show } from '../../scene.js';

export type Contact = Record<string, unknown> & {
  geometry1: Element;
  geometry2: Element;
  position: number[];
  depth: number;
};

/** A ball of 0.5 m that lies on a floor whose upper side is at 0, or falls on it. */
export const scene = (height: number, rest = ''): [string, string][] =>
  bothSpellings(`
    <x3d-rigid-body-collection id="c" def="C">
      <x3d-rigid-body id="floor" fixed="true" position="0 -0.5 0">
        <x3d-collidable-shape def="floorshape"><shape><box size="10 1 10"></box></shape></x3d-collidable-shape>
      </x3d-rigid-body>
      <x3d-rigid-body id="ball" position="0 ${height} 0">
        <x3d-collidable-shape def="ballshape"><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>
      </x3d-rigid-body>
    </x3d-rigid-body-collection>${rest}`);

export const SENSOR = `
  <x3d-collision-sensor id="sensor" def="S">
    <x3d-collision-collection id="k" appliedparameters='"BOUNCE"'>
      <x3d-collidable-shape use="floorshape"></x3d-collidable-shape><x3d-collidable-shape use="ballshape"></x3d-collidable-shape>
    </x3d-collision-collection>
  </x3d-collision-sensor>`;

export async function paused(markup: string) {
  const shown = await show(markup, '#c');
  shown.world.paused = true;
  shown.world.reset();
  return shown;
}
