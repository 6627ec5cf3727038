import { codecs, type World } from '../../../physics-core/inside.js';
import { GeometryReader, placed } from '../document/geometry-reader.js';
import { holdersOf, placesOf } from '../document/structure.js';
import { worldFor } from '../document/world-for.js';
import { identity, isIdentity, type Affine } from '../geometry/matrix.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { collectionNode, type Plan } from '../plans/plan.js';
import { holdsNodes } from '../words/fields.js';
import { frameOf, mapped, scaleIn } from './frame.js';

/** The ParticleSystems that it stands in, or that name it, in document order. */
const systemsOf = (part: Binding): Binding[] =>
  placesOf(part)
    .flatMap((place) => holdersOf(place, part, 'ParticleSystem'))
    .filter(({ scope }) => scope);

/** An emitter or a model lives where its system does. */
export function worldOfPart(part: Binding): PageWorld | undefined {
  const [system] = systemsOf(part);
  return system && worldFor(part.use(system));
}

/** From what it says in the frame of its system to the world, or to the body that carries it. */
const MAPPED: Record<string, (matrix: Affine, value: never, length: number) => unknown> = {
  position: (matrix, value: number[], length) =>
    mapped(
      matrix,
      value.map((each) => each / length),
      1,
    ).map((each) => each * length),
  direction: (matrix, value: number[]) => mapped(matrix, value, 0),
  force: (matrix, value: number[]) => mapped(matrix, value, 0),
  // What flies in a scaled frame flies as it would in its own.
  speed: (matrix, value: number) => value * scaleIn(matrix),
  // The area by which a wind accelerates so much more, not that of what is larger.
  surfaceArea: (matrix, value: number) => value * scaleIn(matrix),
};

/** Of these fields a wind says how strong it is, not how far something goes. */
const isStrength = (part: Binding, name: string): boolean =>
  part.is('WindPhysicsModel') && name === 'speed';

function placedFields(part: Binding, matrix: Affine): Record<string, unknown> {
  const relations: Record<string, unknown> = {};
  if (isIdentity(matrix)) return relations;
  const asked = part.authoredFields();
  for (const [name, map] of Object.entries(MAPPED)) {
    const field = part.type.fields[name];
    if (!field || isStrength(part, name)) continue;
    const value = codecs[field.type].accept(asked[name] ?? field.default);
    if (value !== undefined) relations[name] = map(matrix, value as never, part.units.length);
  }
  return relations;
}

const isGeometry = (name: string): boolean => !/^(metadata|coordinate)/.test(name);

/** Of its geometry, the triangles or points, where its system has them. */
function readShape(part: Binding, matrix: Affine): Record<string, unknown> {
  const reader = new GeometryReader(part);
  const { length } = part.units;
  const elements = (name: string): Element[] => part.named(name) ?? [...part.element.children];
  for (const name of ['surface', 'geometry']) {
    if (!part.type.fields[name]) continue;
    const data = reader.single(elements(name), part.scope!, isGeometry);
    return { [name]: data ? placed(data, matrix, length) : null };
  }
  if (!part.type.fields.coord) return {};
  const points = reader.coord(elements('coord'), part.scope!);
  return { coord: isIdentity(matrix) ? points : eachPoint(points, matrix, length) };
}

function eachPoint(points: number[], matrix: Affine, length: number): number[] {
  const out: number[] = [];
  for (let i = 0; i + 2 < points.length; i += 3) {
    const point = points.slice(i, i + 3).map((each) => each / length);
    for (const each of mapped(matrix, point, 1)) out.push(each * length);
  }
  return out;
}

/** What is carried by a body flies in the world, where forces, winds and walls are. */
function matrixOf(part: Binding, system: Binding): Affine {
  const { body, matrix } = frameOf(system, part);
  return body && part.type.containerField === 'physics' ? identity() : matrix;
}

/** All that a part says, as it is in the frame of one of its systems. */
export const fieldsIn = (part: Binding, system: Binding): Record<string, unknown> => {
  const matrix = matrixOf(part, system);
  return { ...placedFields(part, matrix), ...readShape(part, matrix) };
};

/** Whether a system can't have the node of the part itself: that lives, or says a place, where its first system is. */
export function isApart(part: Binding, system: Binding): boolean {
  const [first] = systemsOf(part);
  if (!first || first === system) return false;
  return (
    worldFor(first) !== worldFor(system) ||
    String(matrixOf(part, first)) !== String(matrixOf(part, system))
  );
}

/** Its own fields, so that each edit of them is planned, and reaches all systems that have it. */
function ownFields(part: Binding): Record<string, unknown> {
  const asked = part.authoredFields();
  const own: Record<string, unknown> = {};
  for (const [name, field] of Object.entries(part.type.fields)) {
    if (field.access === 'outputOnly' || field.access === 'inputOnly' || holdsNodes(field))
      continue;
    const value = codecs[field.type].accept(asked[name] ?? field.default);
    if (value !== undefined) own[name] = value;
  }
  return own;
}

/** Those that several systems had when they were planned last. */
const shared = new WeakSet<Binding>();

/** What one of several has for itself follows from what the part says. */
function tellSystems(part: Binding, systems: readonly Binding[]): void {
  const before = shared.has(part);
  const isShared = systems.length > 1;
  if (isShared) shared.add(part);
  else shared.delete(part);
  if (before || isShared) for (const each of systems) each.dirty();
}

export function planPart(part: Binding, world: World): Plan {
  const systems = systemsOf(part);
  const [system] = systems;
  tellSystems(part, systems);
  const apart = systems.some((each) => isApart(part, each));
  return {
    world,
    collection: system ? system.node?.collection : collectionNode(part),
    relations: { ...(apart && ownFields(part)), ...(system && fieldsIn(part, system)) },
  };
}
