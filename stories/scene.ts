// What the stories of single nodes share: a page around the scene, its camera and lights, the ground, colours.
import { html, nothing, type TemplateResult } from 'lit';

type Content = TemplateResult | typeof nothing;

const COLORS = {
  red: '0.6 0.06 0.04',
  brass: '0.75 0.42 0.1',
  blue: '0.03 0.3 0.42',
  iron: '0.17 0.21 0.26',
};

/** A Shape of one colour. */
export const shape = (color: keyof typeof COLORS, geometry: Content, id?: string) => html`
  <shape id=${id ?? nothing}>
    <appearance>
      <material
        diffuseColor=${COLORS[color]}
        specularColor="0.2 0.2 0.2"
        shininess="0.5"
      ></material>
    </appearance>
    ${geometry}
  </shape>
`;

/** The shape of the ground. */
export const slab = html`
  <shape>
    <appearance>
      <material></material>
      <pixeltexture image="2 2 3 0xC4CAD1 0xB7BEC7 0xB7BEC7 0xC4CAD1">
        <textureproperties magnificationFilter="NEAREST_PIXEL"></textureproperties>
      </pixeltexture>
      <texturetransform scale="6 6"></texturetransform>
    </appearance>
    <box size="12 1 12"></box>
  </shape>
`;

/** A fixed floor whose top is at y = 0. */
export const ground = html`
  <transform translation="0 -0.5 0">
    ${slab}
    <x3d-rigid-body fixed></x3d-rigid-body>
  </transform>
`;

/** Every world of the scene, back to what its markup says. */
function startAgain({ currentTarget }: Event): void {
  const main = (currentTarget as Element).closest('main')!;
  const bodies = [...main.querySelectorAll('x3d-rigid-body')];
  for (const world of new Set(bodies.map((body) => body.world))) world?.reset();
}

/** Where a scene is seen from: the front, further back for what begins high or swings, from above, or from far off. */
const VIEWS = {
  front: { position: '0 3.4 9', orientation: '1 0 0 -0.2', centerOfRotation: '0 1.5 0' },
  high: { position: '0 4.4 13.5', orientation: '1 0 0 -0.1', centerOfRotation: '0 2.5 0' },
  pendulum: { position: '0 5.4 12.6', orientation: '1 0 0 -0.1', centerOfRotation: '0 4 0' },
  above: { position: '0 6.6 9.6', orientation: '1 0 0 -0.58', centerOfRotation: '0 0.5 0' },
  wide: { position: '0 12 31', orientation: '1 0 0 -0.26', centerOfRotation: '0 3 0' },
};

/** Thousands of bodies are drawn in the time that one picture has. */
const SHADOWS = { front: 0.45, high: 0.45, pendulum: 0.45, above: 0.45, wide: 0 };

interface Page {
  view?: keyof typeof VIEWS;
  /** Beside the one that every page has. */
  buttons?: Content;
  /** Numbers, a log: beside the scene where there is room, else after it. */
  beside?: Content;
  after?: Content;
}

/** Where everything is drawn: camera, lights, and what stands in the scene. */
export const stage = (view: keyof typeof VIEWS, content: Content) => html`
  <x3d>
    <scene>
      <viewpoint
        position=${VIEWS[view].position}
        orientation=${VIEWS[view].orientation}
        centerOfRotation=${VIEWS[view].centerOfRotation}
      ></viewpoint>
      <background transparency="1"></background>
      <navigationinfo headlight="false"></navigationinfo>
      <directionallight
        direction="-0.5 -1 -0.4"
        intensity="0.8"
        ambientIntensity="0.35"
        shadowIntensity=${SHADOWS[view]}
        shadowFilterSize="4"
      ></directionallight>
      <directionallight direction="0.6 -0.3 -0.7" intensity="0.3"></directionallight>
      ${content}
    </scene>
  </x3d>
`;

/** A page with one scene. Lit renders controls into it as edits of the running elements. */
export const scene = (
  text: string | TemplateResult,
  content: Content,
  { view = 'front', buttons = nothing, beside = nothing, after = nothing }: Page = {},
) => html`
  <main>
    <p>${text}</p>
    ${stage(view, content)}
    <div>
      <button type="button" @click=${startAgain}>Start again</button>
      ${buttons}
    </div>
    ${beside === nothing ? nothing : html`<div class="beside">${beside}</div>`} ${after}
  </main>
`;
