import type { BodyNode } from '../../nodes/body.js';
import type { CollidablePart } from '../../nodes/collidable.js';
import { JointNode } from '../../nodes/joint.js';
import { rotate, scale, type Pose } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { World } from '../../world/world.js';
import { COLOR, type Color } from './colors.js';
import { markContacts } from './contact-marks.js';
import { markJoint } from './joint-marks.js';
import { LineBuffer } from './line-buffer.js';
import { Outlines } from './outlines.js';

/** Share of a body's size that marks on it have. */
const MARK = 0.25;

/** The edges of a body's shape, in the frame of its centre of mass. */
interface Outline {
  /** A body's parts are another list whenever its shape is made anew. */
  parts: readonly CollidablePart[];
  lines: Float32Array;
  /** Distance of the farthest corner, metres. */
  reach: number;
}

/** A world as Bullet has it, as coloured lines in the world's frame: shapes, centres of mass, joints, contacts. */
export class DebugLines extends LineBuffer {
  readonly #world: World;
  readonly #outlines: Outlines;
  readonly #byBody = new WeakMap<BodyNode, Outline>();
  readonly #pose = new Float64Array(7);

  constructor(world: World) {
    super();
    this.#world = world;
    this.#outlines = new Outlines(world);
  }

  /** Draws all of it anew, edits that wait included. */
  update(): void {
    this.#world.flush();
    const { bodies, nodes } = this.#world;
    this.clear();
    for (const body of bodies) if (body.built) this.#body(body);
    for (const node of nodes) if (node instanceof JointNode && node.attached) markJoint(this, node);
    markContacts(this, this.#world);
  }

  dispose(): void {
    this.#outlines.dispose();
  }

  /** How large marks on a body are, metres. */
  markOn(body: BodyNode): number {
    return MARK * this.#outlineOf(body).reach;
  }

  /** The pose of a body's centre of mass, as Bullet has it. */
  poseOf(body: BodyNode): Pose {
    const p = this.#pose;
    this.#world.engine.reader.pose(body.body, body.pointer, p, 0);
    return { p: [p[0]!, p[1]!, p[2]!], q: [p[3]!, p[4]!, p[5]!, p[6]!] };
  }

  #outlineOf(body: BodyNode): Outline {
    const known = this.#byBody.get(body);
    if (known?.parts === body.solidParts) return known;
    const lines = this.#outlines.of(body.body.getCollisionShape());
    let reach = 0;
    for (let i = 0; i < lines.length; i += 3)
      reach = Math.max(reach, Math.hypot(lines[i]!, lines[i + 1]!, lines[i + 2]!));
    const outline = { parts: body.solidParts, lines, reach };
    this.#byBody.set(body, outline);
    return outline;
  }

  #body(body: BodyNode): void {
    const { lines, reach } = this.#outlineOf(body);
    const pose = this.poseOf(body);
    this.#place(lines, pose, colorOf(body));
    if (!body.movable) return;
    const axes = AXES.map((axis) => scale(rotate(pose.q, axis), MARK * reach));
    this.cross(pose.p, axes, COLOR.mass);
  }

  /** Lines of a frame, in the world's. */
  #place(lines: Float32Array, { p, q }: Pose, color: Color): void {
    const [xx, xy, xz] = rotate(q, [1, 0, 0]);
    const [yx, yy, yz] = rotate(q, [0, 1, 0]);
    const [zx, zy, zz] = rotate(q, [0, 0, 1]);
    for (let i = 0; i < lines.length; i += 6) {
      const a = lines[i]!;
      const b = lines[i + 1]!;
      const c = lines[i + 2]!;
      const d = lines[i + 3]!;
      const e = lines[i + 4]!;
      const f = lines[i + 5]!;
      this.put(
        p[0] + a * xx + b * yx + c * zx,
        p[1] + a * xy + b * yy + c * zy,
        p[2] + a * xz + b * yz + c * zz,
        p[0] + d * xx + e * yx + f * zx,
        p[1] + d * xy + e * yy + f * zy,
        p[2] + d * xz + e * yz + f * zz,
        color,
      );
    }
  }
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function colorOf(body: BodyNode): Color {
  if (!body.active) return COLOR.out;
  if (body.body.isKinematicObject()) return COLOR.kinematic;
  if (body.body.isStaticObject()) return COLOR.fixed;
  return body.sleeping ? COLOR.sleeping : COLOR.awake;
}
