import { hypot } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Joint } from '../../dynamics/joint.js';
import { add, AXES, compose, rotate, scale, type Pose } from '../../base/math.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { COLOR, type Color } from './colors.js';
import { markContacts } from './contact-marks.js';
import { markJoint } from './joint-marks.js';
import { LineBuffer } from './line-buffer.js';
import { drawMatter, type Matter } from './matter-lines.js';
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

/** What is drawn beside bodies. */
export interface DebugScene {
  /** Applies edits that wait. */
  flush(): void;
  joints(): Iterable<Joint>;
  /** Ropes, cloth and soft bodies. */
  matter(): Iterable<Matter>;
}

/** A world whose steps another thread may take, which finds its contact points, too. */
export interface DrawnSimulation extends Simulation {
  readonly elsewhere: { readonly contacts: Float64Array } | undefined;
  /** What it did, and where another run has its bodies while somebody looks at that, seen from Bullet's origin. */
  readonly timeline:
    { eachGhost(put: (id: number, pose: Float32Array) => void): boolean } | undefined;
}

/** A world as Bullet has it, as coloured lines in the world's frame: shapes, centres of mass, joints, contacts, and what is not rigid. */
export class DebugLines extends LineBuffer {
  readonly #simulation: DrawnSimulation;
  readonly #scene: DebugScene;
  readonly #outlines: Outlines;
  readonly #byBody = new WeakMap<Body, Outline>();
  readonly #pose = new Float64Array(POSE);

  constructor(simulation: DrawnSimulation, scene: DebugScene) {
    super();
    this.#simulation = simulation;
    this.#scene = scene;
    this.#outlines = new Outlines(simulation);
  }

  /** Draws all of it anew, edits that wait included. */
  update(): void {
    this.#scene.flush();
    this.clear();
    for (const body of this.#simulation.bodies) this.#body(body);
    for (const matter of this.#scene.matter()) drawMatter(this, matter);
    for (const joint of this.#scene.joints())
      if (joint.attached) markJoint(this, this.#simulation, joint);
    markContacts(this, this.#simulation, this.#simulation.elsewhere?.contacts);
    this.#ghosts();
  }

  /** Draws only the ghosts anew: it may be that nobody asked for the rest. */
  updateGhosts(): void {
    this.clear();
    this.#ghosts();
  }

  dispose(): void {
    this.#outlines.dispose();
  }

  /** How large marks on a body are, metres. */
  markOn(body: Body): number {
    return MARK * this.#outlineOf(body).reach;
  }

  /** The pose of a body's centre of mass, or of the world, as Bullet has it. */
  poseOf(body: Body | undefined): Pose {
    const p = this.#pose;
    const { engine, poses } = this.#simulation;
    if (!body) return { p: [...poses.origin], q: [0, 0, 0, 1] };
    engine.reader.pose(body.pointer, p, 0);
    return { p: add([p[0]!, p[1]!, p[2]!], poses.origin), q: [p[3]!, p[4]!, p[5]!, p[6]!] };
  }

  #outlineOf(body: Body): Outline {
    const known = this.#byBody.get(body);
    if (known?.parts === body.solidParts) return known;
    const lines = this.#outlines.of(body.body.getCollisionShape());
    let reach = 0;
    for (let i = 0; i < lines.length; i += 3)
      reach = Math.max(reach, hypot(lines[i]!, lines[i + 1]!, lines[i + 2]!));
    const outline = { parts: body.solidParts, lines, reach };
    this.#byBody.set(body, outline);
    return outline;
  }

  #body(body: Body): void {
    const { lines, reach } = this.#outlineOf(body);
    const pose = this.poseOf(body);
    this.#place(lines, pose, colorOf(body));
    if (!body.movable) return;
    const axes = AXES.map((axis) => scale(rotate(pose.q, axis), MARK * reach));
    this.cross(pose.p, axes, COLOR.mass);
  }

  /** Outlines of what moves. A pose of those is of a body's own frame. */
  #ghosts(): void {
    const { bodies, poses, timeline } = this.#simulation;
    if (!timeline) return;
    let byId: Map<number, Body> | undefined;
    timeline.eachGhost((id, [x, y, z, ...q]) => {
      byId ??= new Map([...bodies].map((body) => [body.id, body]));
      const body = byId.get(id);
      if (!body?.movable) return;
      const frame = { p: add([x, y, z], poses.origin), q } as Pose;
      this.#place(this.#outlineOf(body).lines, compose(frame, body.centerOfMass), COLOR.ghost);
    });
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

function colorOf(body: Body): Color {
  if (!body.active) return COLOR.out;
  if (body.body.isKinematicObject()) return COLOR.kinematic;
  if (body.body.isStaticObject()) return COLOR.fixed;
  return body.sleeping ? COLOR.sleeping : COLOR.awake;
}
