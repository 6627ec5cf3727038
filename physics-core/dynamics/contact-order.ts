import type { Body } from './body.js';

/**
 * Body1 of a Contact: the one that moves, of two that do the one made later. Its geometry is geometry1, the normal
 * points into it, and surface speed carries it along the other.
 */
export function carriedBy(a: Body, b: Body): Body {
  if (a.movable !== b.movable) return a.movable ? a : b;
  return a.id > b.id ? a : b;
}
