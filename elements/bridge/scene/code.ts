import { chunks, contacts, drags, meshes, type Chunk } from '../../../physics-core/inside.js';
import { attribute, isPhysics, isScene, isShape, isType, lowerName, typeOf } from '../words/dom.js';
import { lacks, shapes } from '../x3dom/shapes/shapes.js';
import { prefetchEngine } from './engine.js';
import { lateCode } from './late-tags.js';

/** What Bullet has shapes for, and what is no geometry. */
const WITHOUT_TRIANGLES = /^(box|sphere|cylinder|cone|appearance|metadata.*)$/;

/** Begins fetching what physics elements call for, while x3dom and the rest of the page are read. */
export function prefetch(elements: Iterable<Element>): void {
  const all = [...elements];
  for (const element of all) fetchCode(lateCode(element));
  const physics = all.filter(isPhysics);
  if (physics.length === 0) return;
  prefetchEngine();
  if (all.some(lacks)) fetchCode(shapes);
  if (chunks.every(({ here }) => here)) return;
  for (const element of physics) fetchCode(typeOf(element)?.chunk);
  const bodies = physics.filter(
    (element) => isType(element, 'RigidBody') && attribute(element, 'USE') === null,
  );
  if (bodies.length > 1) fetchCode(contacts);
  if (physics.some((element) => attribute(element, 'draggable-body') !== null)) fetchCode(drags);
  if (all.some(isCollidingMesh)) fetchCode(meshes);
}

/** Worlds tell of what could not be had. */
function fetchCode(chunk: Chunk<unknown> | undefined): void {
  chunk?.load().catch(() => {});
}

/** Geometry made of triangles, of a collidable or beside a body. */
function isCollidingMesh(element: Element): boolean {
  const shape = element.parentElement;
  if (!shape || !isShape(shape) || WITHOUT_TRIANGLES.test(lowerName(element))) return false;
  for (let at = shape.parentElement; at && !isScene(at); at = at.parentElement)
    if (isPhysics(at) || [...at.children].some((child) => isType(child, 'RigidBody'))) return true;
  return false;
}
