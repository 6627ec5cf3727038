import { HOOKS } from '../page/libraries/library.js';
import { ours } from '../page/libraries/ours.js';
import { boxes } from '../page/scene.js';

/** Metres between two bodies, which turn and do not touch. */
const GAP = 2;

const body = (place: number[], color: number[], spin: number): string => `
  <transform translation="${place.join(' ')}">
    <shape>
      <appearance><material diffusecolor="${color.join(' ')}"></material></appearance>
      <box size="1 1 1"></box>
    </shape>
    <x3d-rigid-body angularvelocity="${spin} 1 0" autodisable="false"></x3d-rigid-body>
  </transform>`;

/** So many boxes of many colours that all turn, written out one by one, on a page. */
export function pageOf(count: number): string {
  const side = Math.ceil(Math.cbrt(count));
  const bodies = Array.from({ length: count }, (_, i) => {
    const [x, y, z] = [i % side, Math.floor(i / side) % side, Math.floor(i / side / side)];
    const place = [(x - side / 2) * GAP, (y - side / 2) * GAP, -z * GAP];
    return body(place, [(i % 7) / 7, (i % 5) / 5, 0.4], 1 + (i % 3));
  });
  return `<!DOCTYPE html>
    <link rel="stylesheet" href="/node_modules/x3dom/x3dom.css">
    <script src="/node_modules/x3dom/x3dom.js"></script>
    <script type="module" src="/dist/x3d-physics.js"></script>
    <x3d width="64px" height="48px"><scene>
      <viewpoint position="0 0 ${2.5 * side}"></viewpoint>
      <x3d-rigid-body-collection id="c" default gravity="0 0 0"></x3d-rigid-body-collection>
      ${bodies.join('')}
    </scene></x3d>`;
}

/** Scene 3 of the paper, as `npm run lab -- page` has it: boxes fall into a room, where a ball stirs them. */
export const roomOf = (count: number): string =>
  ours.page(boxes(count), '').replace(HOOKS('ours'), '');
