import { codecs, type World } from '../../../physics-core/inside.js';
import { nodesOf, placesOf } from '../document/structure.js';
import { worldFor } from '../document/world-for.js';
import { worldAround } from '../matter/world-of.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { collectionNode, nodesIn, type Plan } from '../plans/plan.js';
import { subtree } from '../words/dom.js';
import { drawingOf } from './cloud-drawing.js';
import { frameOf, scaleIn } from './frame.js';
import { dropParts, partsIn } from './own-parts.js';
import { LOOKS, partOf } from './parts.js';

/** That of its body; of the collection that it stands in; else the only one, where bodies are that it may meet. */
export function worldOfSystem(system: Binding): PageWorld | undefined {
  if (placesOf(system).length === 0) return undefined;
  const { body } = frameOf(system);
  if (body) return body.scope ? worldFor(body) : undefined;
  return worldAround(system);
}

export function planSystem(system: Binding, world: World): Plan {
  const { body, matrix } = frameOf(system);
  const only = (role: string, types: string[]): Binding[] =>
    nodesOf(system, role, ...types).slice(0, 1);
  const { emitter, physics, particleSize } = system.type.fields;
  const relations: Record<string, unknown> = {
    emitter: partsIn(world, only('emitter', [...emitter.nodes!]), system)[0] ?? null,
    physics: partsIn(world, nodesOf(system, 'physics', ...physics.nodes!), system),
    body: (body && nodesIn(world, [body], system)[0]) ?? null,
  };
  const scale = scaleIn(matrix);
  const asked = system.authoredFields().particleSize ?? particleSize.default;
  const size = codecs.SFVec2f.accept(asked);
  if (Math.abs(scale - 1) > SAME && size)
    relations.particleSize = (size as number[]).map((each) => each * scale);
  watchLooks(system);
  const drawing = drawingOf(system);
  system.onnode = () => {
    dropParts(system);
    drawing.nodeChanged();
  };
  return { world, collection: collectionNode(system), relations };
}

/** Edits of what it is drawn with are seen. */
function watchLooks(system: Binding): void {
  const { readers } = system.scene!;
  for (const root of LOOKS.map(([name, tag]) => partOf(system, name, tag)))
    if (root) for (const element of subtree(root)) readers.add(element, system);
}

/** Turned as often as one likes, nothing gets larger; rounding of a few products of matrices, a pure number. */
const SAME = 1e-9;
