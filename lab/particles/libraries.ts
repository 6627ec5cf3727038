import { readFileSync } from 'node:fs';
import { HOOKS, SIZE, STYLE, text } from '../page/libraries/library.js';
import { hanging, type Body } from './bodies.js';
import type { Form } from './forms.js';
import { FOUNTAIN } from './fountain.js';
import { systemMarkup, viewpoint } from './markup.js';

/** A library that the fountain is shown by. */
export interface Library {
  /** As numbers and pictures name it. */
  id: string;
  name: string;
  /** What draws it, of whose release that stands. */
  package: string;
  /** What it does in a frame. */
  says: string;
  page(form: Form, count: number, address: string): string;
  /** A file beside the page, where it has one. */
  file?(form: Form, count: number): string;
}

/** As it is installed. */
export function versionOf(library: Library): string {
  const text = readFileSync(`node_modules/${library.package}/package.json`, 'utf8');
  return (JSON.parse(text) as { version: string }).version;
}

/** Of each colour, its share of a life. */
const SHARES = FOUNTAIN.colors.map((_, i) => i / (FOUNTAIN.colors.length - 1));

const kebab = (name: string): string =>
  `x3d${name.replaceAll(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

function bodyMarkup({ position, shape, spin }: Body): string {
  const geometry =
    shape.type === 'Sphere'
      ? `<Sphere radius="${shape.radius}"></Sphere>`
      : `<Box size="${text(shape.size)}"></Box>`;
  return `<Transform translation="${text(position)}"><Shape><Appearance><Material></Material></Appearance>${geometry}</Shape><x3d-rigid-body useGlobalGravity="false" autoDisable="false" angularVelocity="${text(spin)}"></x3d-rigid-body></Transform>`;
}

const ours: Library = {
  id: 'ours',
  name: 'x3d-physics',
  package: 'x3dom',
  says: "this library at `standard`, two steps of 1/120 s, on the page's own thread; particles move and are placed in JavaScript, in double precision",
  page(form, count) {
    const system = form.bodies ? 'collides="true" bounce="0.6"' : '';
    const keys = SHARES.map((share) => share * FOUNTAIN.life);
    return `<!DOCTYPE html><meta charset="utf-8">${HOOKS('ours')}${STYLE}
<link rel="stylesheet" href="/node_modules/x3dom/x3dom.css"><script src="/node_modules/x3dom/x3dom.js"></script>
<script type="module" src="/dist/x3d-physics.js"></script>
<body><X3D width="${SIZE.width}px" height="${SIZE.height}px"><Scene>${viewpoint}
${hanging(form.bodies ?? 0)
  .map(bodyMarkup)
  .join('\n')}
${systemMarkup({ tag: kebab, system, keys }, form, count)}
</Scene></X3D></body>`;
  },
};

/** Of each tag that stands elsewhere than in `children`, where it stands. */
const xIte: Library = {
  id: 'x-ite',
  name: 'X_ITE',
  package: 'x_ite',
  says: 'as it comes: its particles move on the graphics card (transform feedback), so script only says so; they meet no bodies, and no script can read where they are',
  page: (_form, _count, address) =>
    `<!DOCTYPE html><meta charset="utf-8">${HOOKS('x-ite')}${STYLE}<script src="/node_modules/x_ite/dist/x_ite.min.js"></script><body><x3d-canvas src="${address.replace('/page?', '/file?')}" style="width: ${SIZE.width}px; height: ${SIZE.height}px"></x3d-canvas></body>`,
  file: (
    form,
    count,
  ) => `<X3D profile="Interchange" version="4.0"><head><component name="ParticleSystems" level="3"/></head><Scene>${viewpoint}
${systemMarkup({ tag: (node) => node, system: 'DEF="system"', keys: SHARES }, form, count)}
</Scene></X3D>`,
};

const babylon: Library = {
  id: 'babylon',
  name: 'Babylon.js',
  package: '@babylonjs/core',
  says: "its ParticleSystem, on the processor: one step of 1/60 s by Euler's rule; its particles meet no bodies, and those that fade are drawn in no order",
  page: (form, count) =>
    `<!DOCTYPE html><meta charset="utf-8">${HOOKS('babylon')}${STYLE}<body><canvas width="${SIZE.width}" height="${SIZE.height}"></canvas><script src="/babylon.js" data-count="${count}" data-fades="${Boolean(form.fades)}"></script></body>`,
};

export const libraries: readonly Library[] = [ours, xIte, babylon];

export function libraryOf(id: string): Library {
  const found = libraries.find((library) => library.id === id);
  if (!found) throw new Error(`no library ${id}`);
  return found;
}
