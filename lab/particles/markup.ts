import { text } from '../page/libraries/library.js';
import { EYE, FADING, FOUNTAIN, MASS } from './fountain.js';
import type { Form } from './forms.js';

/** A system in the words of X3D, of which `tags` has the spelling of each; `keys`: when each of its colours is reached. */
export interface Spelling {
  tag(node: string): string;
  system: string;
  keys: readonly number[];
}

const CORNERS = '0.05 0.05 0.05 -0.05 -0.05 0.05 -0.05 0.05 -0.05 0.05 -0.05 -0.05';
const TETRAHEDRON = `<IndexedFaceSet coordIndex="0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1"><Coordinate point="${CORNERS}"></Coordinate></IndexedFaceSet>`;

export function systemMarkup({ tag, system, keys }: Spelling, form: Form, count: number): string {
  const { geometryType, fades } = form;
  const { life, angle, speed, variation, size, gravity, colors } = FOUNTAIN;
  const node = (name: string, fields: string, inside = ''): string =>
    `<${tag(name)} ${fields}>${inside}</${tag(name)}>`;
  const ramp = (fades ? FADING : colors).map((color) => text(color)).join(' ');
  return node(
    'ParticleSystem',
    `${system} geometryType="${geometryType}" particleSize="${size} ${size}" maxParticles="${count}" particleLifetime="${life}" lifetimeVariation="0" colorKey="${text(keys)}"`,
    [
      '<Appearance><Material></Material></Appearance>',
      `<ColorRGBA color="${ramp}"></ColorRGBA>`,
      geometryType === 'GEOMETRY' ? TETRAHEDRON : '',
      node(
        'ConeEmitter',
        `angle="${angle}" speed="${speed}" variation="${variation}" mass="${MASS}"`,
      ),
      node('ForcePhysicsModel', `force="0 ${gravity * MASS} 0"`),
    ].join(''),
  );
}

export const viewpoint = `<Viewpoint position="${text(EYE)}"></Viewpoint>`;
