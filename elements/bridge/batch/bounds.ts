import type { X3DBounded, X3DTransform, X3DVolume } from '../x3dom/renderer.js';
import type { X3DMatrix } from '../x3dom/x3dom.js';

// Where a Transform is that x3dom passes by: for the bounds of the scene, which decide the near and far planes and
// the maps of shadows, and for whoever asks for its own. In place, where x3dom makes some twenty vectors for each.

interface Bounded {
  readonly transform: X3DTransform;
  readonly shape: X3DBounded | undefined;
  readonly parent: X3DBounded | undefined;
  moved: boolean;
}

export function takeBounds(member: Bounded): void {
  const { transform } = member;
  let known = false;
  /** Every writer of its matrix calls this, x3dom itself included. */
  transform.invalidateVolume = () => {
    member.moved = true;
    known = false;
    transform._graph.globalMatrix = null;
    // Where the parent's are unknown, so are those of all above it.
    if (member.parent?.volumeValid()) member.parent.invalidateVolume();
  };
  transform.getVolume = () => {
    const { volume } = transform._graph;
    if (known) return volume;
    known = true;
    volume.valid = false;
    if (!transform.renderFlag()) return volume;
    const inside = member.shape!.getVolume();
    if (inside.valid) placed(inside, transform._trafo, volume);
    return volume;
  };
}

/** The box around a box that was turned, to the last bit as x3dom finds it: shadows hang on that. */
function placed({ min, max }: X3DVolume, m: X3DMatrix, out: X3DVolume): void {
  const { center, radialVec: half, min: from, max: to } = out;
  from.x = to.x = m._03;
  from.y = to.y = m._13;
  from.z = to.z = m._23;
  stretch(out, 'x', m._00 * max.x, m._00 * min.x);
  stretch(out, 'x', m._01 * max.y, m._01 * min.y);
  stretch(out, 'x', m._02 * max.z, m._02 * min.z);
  stretch(out, 'y', m._10 * max.x, m._10 * min.x);
  stretch(out, 'y', m._11 * max.y, m._11 * min.y);
  stretch(out, 'y', m._12 * max.z, m._12 * min.z);
  stretch(out, 'z', m._20 * max.x, m._20 * min.x);
  stretch(out, 'z', m._21 * max.y, m._21 * min.y);
  stretch(out, 'z', m._22 * max.z, m._22 * min.z);
  half.x = (to.x - from.x) * 0.5;
  half.y = (to.y - from.y) * 0.5;
  half.z = (to.z - from.z) * 0.5;
  center.x = from.x + half.x;
  center.y = from.y + half.y;
  center.z = from.z + half.z;
  out.diameter = 2 * Math.sqrt(half.x * half.x + half.y * half.y + half.z * half.z);
  out.valid = true;
}

function stretch({ min, max }: X3DVolume, axis: 'x' | 'y' | 'z', a: number, b: number): void {
  min[axis] += a < b ? a : b;
  max[axis] += a < b ? b : a;
}
