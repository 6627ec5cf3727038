// What the stories of particles share: how particles look.
import { html, nothing } from 'lit';

/** A round spot with a soft edge: grey, and how much of it is seen. */
const spot = html`
  <pixeltexture
    repeatS="false"
    repeatT="false"
    image="4 4 2 0xFF00 0xFF40 0xFF40 0xFF00 0xFF40 0xFFFF 0xFFFF 0xFF40 0xFF40 0xFFFF 0xFFFF 0xFF40 0xFF00 0xFF40 0xFF40 0xFF00"
  ></pixeltexture>
`;

/** Spots in the colours of their age, which get smaller as they fade: what is seen by less than a third is left out. */
export const spots = html`
  <appearance sortType="transparent" alphaClipThreshold="0.35">
    <material></material>
    ${spot}
  </appearance>
`;

/** Spots without an edge. */
export const puffs = html`
  <appearance sortType="transparent">
    <material></material>
    ${spot}
  </appearance>
`;

/** Of one colour; lines and points are to shine, since no light falls on them. */
export const plainLook = (color: string, shines = false) => html`
  <appearance>
    <material diffuseColor=${color} emissiveColor=${shines ? color : nothing}></material>
  </appearance>
`;

/** A box that one looks through. */
export const glass = (size: string) => html`
  <shape>
    <appearance>
      <material diffuseColor="0.03 0.3 0.42" transparency="0.85"></material>
    </appearance>
    <box size=${size}></box>
  </shape>
`;

/** Colours from birth on, the last one fading away; at ages that colorKey names. */
export const fading = (...colors: string[]) =>
  html`<colorrgba color=${colors.join(', ')}></colorrgba>`;

export const range = (min: number, max: number, step: number) =>
  ({ control: { type: 'range', min, max, step } }) as const;
