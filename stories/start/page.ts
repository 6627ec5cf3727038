/// <reference types="vite/client" />
// The page that opens first: what this is, one scene that moves, the first example, and the ways on.
import { html } from 'lit';
import example from '../../examples/falling-box.html?raw';
import { copyable } from '../copyable.js';
import { controls } from './controls.js';
import {
  addressOf,
  backFrom,
  isFile,
  PAGES,
  ROOMS,
  SCRIPTS,
  type Link,
  type Room,
} from './links.js';
import { startScene } from './scene.js';

/** Stories and the site open in the frame of all stories; another file by itself. */
const targetOf = (link: Link) => (isFile(link) && !link.to.startsWith('../') ? '_blank' : '_top');

const way = (link: Link) =>
  html`<li>
    <a href=${addressOf(link)} target=${targetOf(link)}>${link.text}</a>
  </li>`;

const room = ({ title, links }: Room) => html`
  <section>
    <h2>${title}</h2>
    <ul>
      ${links.map(way)}
    </ul>
  </section>
`;

const [x3dom, physics] = SCRIPTS.map(
  (link) => html`<a href=${addressOf(link)} download>${link.text}</a>`,
);

/** Its scripts beside it, as an author has them; in the repository they are elsewhere. */
const firstPage = example.replaceAll(/"[^"]*\/([\w.-]+\.js)"/g, '"$1"').trim();

export const startPage = () => html`
  <main class="start">
    <h1>x3d-physics</h1>
    <p class="lead">
      The rigid body physics of the X3D standard for
      <a href="https://www.x3dom.org" target="_top">X3DOM</a>, as custom elements. Write the markup,
      open the page, and it moves. Edit it while it runs, and the running world is patched.
    </p>
    <section class="moving" aria-label="A scene">
      <p>Take the weight and throw it at the boxes; drag beside them to look around.</p>
      ${startScene} ${controls}
    </section>
    <nav class="rooms" aria-label="Ways on">
      <section>
        <h2>Writing it</h2>
        <ul>
          <li><a href="#falling-box">A falling box in a minute</a></li>
          <li><a href="#nodes">The nodes, each with its page</a></li>
        </ul>
      </section>
      ${[...backFrom(globalThis.location?.pathname), ...ROOMS].map(room)}
    </nav>
    <section class="first" id="falling-box">
      <h2>A falling box in a minute</h2>
      <p>
        Save this as <code>falling-box.html</code>, put ${x3dom} and ${physics} beside it, and open
        it by double click.
      </p>
      ${copyable(firstPage)}
    </section>
    <nav class="nodes" id="nodes" aria-label="Reference pages">
      <h2>The nodes</h2>
      <p>
        A page for each: its fields with types, defaults and ranges, its events, a live example.
      </p>
      <ul>
        ${PAGES.map(way)}
      </ul>
    </nav>
  </main>
`;
