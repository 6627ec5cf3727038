import type { Hinge, PageScene, Thing } from '../scene.js';
import { HOOKS, isDrawn, SIZE, STYLE, text, type Library } from './library.js';

const shape = ({ shape: of, color }: Thing): string => {
  const geometry =
    typeof of === 'number' ? `<Sphere radius="${of}"></Sphere>` : `<Box size="${text(of)}"></Box>`;
  const material = `<Material diffuseColor="${text(color)}"></Material>`;
  return `<Shape><Appearance>${material}</Appearance>${geometry}</Shape>`;
};

const motor = ({ name, motor: torque }: Thing): string =>
  torque
    ? `<x3d-motor-joint body1="${name}" motor1Axis="0 1 0" axis1Torque="${torque}"></x3d-motor-joint>`
    : '';

function markupOf(thing: Thing): string {
  const { name, mass, position, turn = 0, damping } = thing;
  if (!isDrawn(thing))
    return `<x3d-rigid-body fixed="true" position="${text(position)}"><x3d-collidable-shape>${shape(thing)}</x3d-collidable-shape></x3d-rigid-body>`;
  const damped = damping
    ? ` autoDamp="true" linearDampingFactor="0" angularDampingFactor="${damping}"`
    : '';
  return `<Transform translation="${text(position)}" rotation="0 1 0 ${turn}">${shape(thing)}<x3d-rigid-body id="${name}" mass="${mass}"${damped}></x3d-rigid-body></Transform>${motor(thing)}`;
}

const hinge = ({ bodies: [one, other], anchor }: Hinge): string =>
  `<x3d-single-axis-hinge-joint body1="${one.name}" body2="${other.name}" axis="0 1 0" anchorPoint="${text(anchor)}"></x3d-single-axis-hinge-joint>`;

/** The same text is good for both kinds of pages. */
const sceneOf = ({ things, hinges, eye, down }: PageScene, world: string): string =>
  [
    `<X3D width="${SIZE.width}px" height="${SIZE.height}px"><Scene>`,
    `<Viewpoint position="${text(eye)}" orientation="1 0 0 ${down ? -Math.PI / 2 : 0}"></Viewpoint>`,
    `<x3d-rigid-body-collection default="true" ${world}></x3d-rigid-body-collection>`,
    ...things.map(markupOf),
    ...hinges.map(hinge),
    '</Scene></X3D>',
  ].join('\n');

const X3DOM = `<link rel="stylesheet" href="/node_modules/x3dom/x3dom.css" /><script src="/node_modules/x3dom/x3dom.js"></script>`;
const MODULE = `<script type="module" src="/dist/x3d-physics.js"></script>`;
const CLASSIC = `<script src="/dist/x3d-physics.classic.js"></script>`;

const html =
  (script: string, world = '', adapter = 'ours') =>
  (scene: PageScene) =>
    `<!DOCTYPE html><meta charset="utf-8" />${HOOKS(adapter)}${STYLE}${X3DOM}${script}<body>${sceneOf(scene, world)}</body>`;

const xhtml = (scene: PageScene): string =>
  `<html xmlns="http://www.w3.org/1999/xhtml"><head><title>Scene</title>${HOOKS('ours')}${STYLE}${X3DOM}${CLASSIC}</head><body>${sceneOf(scene, '')}</body></html>`;

const HTML = 'text/html; charset=utf-8';

export const ours: Library = {
  id: 'ours',
  name: 'x3d-physics',
  says: 'this library at `standard` (two steps of 1/120 s) with x3dom 1.8.3, in an HTML page, as a module',
  type: HTML,
  page: html(MODULE),
};

export const oursAwake: Library = {
  ...ours,
  id: 'ours-awake',
  name: 'x3d-physics, rest never',
  says: 'the same with `rest="never"`: what lies still is calculated, too',
  page: html(MODULE, 'rest="never"'),
};

export const oursInWorker: Library = {
  ...ours,
  id: 'ours-worker',
  name: 'x3d-physics, on a worker',
  says: 'the same with `thread="worker"`: what its answers cost the page is script, and its steps are not',
  page: html(MODULE, 'thread="worker"', 'ours-worker'),
};

export const oursClassic: Library = {
  ...ours,
  id: 'ours-classic',
  name: 'x3d-physics, classic',
  says: 'the same by the classic script',
  page: html(CLASSIC),
};

export const oursXhtml: Library = {
  ...ours,
  id: 'ours-xhtml',
  name: 'x3d-physics, XHTML',
  says: 'the same in an XHTML page, by the classic script',
  type: 'application/xhtml+xml; charset=utf-8',
  page: xhtml,
};
