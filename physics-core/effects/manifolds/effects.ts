import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Outline } from '../../shapes/outline.js';
import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { ContactShapes } from './contact-shapes.js';

const WANTED: readonly Outline['kind'][] = ['frustum', 'ellipsoid', 'hull', 'triangles'];

/** A part whose contact points Bullet's own search does not find as they are. */
export const wanted = ({ solidParts }: Body): CollidablePart | undefined =>
  solidParts.find(({ outline }) => outline && WANTED.includes(outline.kind));

const reasonOf = (body: Body): string | undefined => wanted(body) && 'geometry';

export const contactShapes: EffectDescriptor<ContactShapes> = {
  name: 'contact shapes',
  chunk: contacts,
  causes: 'a body with a cylinder, a cone, a hull or triangles, or boxes in touch',
  body: { on: ['mass'], reason: reasonOf },
};
