// The same boxes, which turn in the same way, drawn by three.js as one InstancedMesh.
import * as three from 'three';

/** Where each is, and about what and how fast it turns: as the markup says. */
interface Turning {
  place: number[];
  spin: number[];
  color: number[];
}

const numbers = (element: Element, name: string): number[] =>
  element.getAttribute(name)!.split(' ').map(Number);

const turning = (transform: Element): Turning => ({
  place: numbers(transform, 'translation'),
  spin: numbers(transform.querySelector('x3d-rigid-body')!, 'angularvelocity'),
  color: numbers(transform.querySelector('material')!, 'diffusecolor'),
});

const POSE = 7;

/** Poses as a simulation has them; what that takes is not measured. */
function posesAt(time: number, all: readonly Turning[], poses: Float64Array): void {
  all.forEach(({ place, spin }, i) => {
    const speed = Math.hypot(...spin);
    const s = Math.sin((speed * time) / 2) / speed;
    const turn = [...spin.map((value) => value * s), Math.cos((speed * time) / 2)];
    poses.set([...place, ...turn], i * POSE);
  });
}

export class ThreeBoxes {
  readonly gl: WebGL2RenderingContext;
  readonly #renderer = new three.WebGLRenderer();
  readonly #scene = new three.Scene();
  readonly #camera: three.PerspectiveCamera;
  readonly #mesh: three.InstancedMesh;
  readonly #all: readonly Turning[];
  readonly #poses: Float64Array;
  #time = 0;

  constructor({ width, height }: { width: number; height: number }) {
    this.#all = [...document.querySelectorAll('x3d transform')].map(turning);
    this.#poses = new Float64Array(this.#all.length * POSE);
    this.#renderer.setSize(width, height);
    document.body.append(this.#renderer.domElement);
    this.gl = this.#renderer.getContext() as WebGL2RenderingContext;
    this.#camera = new three.PerspectiveCamera(45, width / height, 1, 1000);
    this.#camera.position.fromArray(numbers(document.querySelector('viewpoint')!, 'position'));
    const light = new three.DirectionalLight(0xffffff, 3);
    light.position.set(0, 0, 1);
    const material = new three.MeshPhongMaterial();
    this.#mesh = new three.InstancedMesh(
      new three.BoxGeometry(1, 1, 1),
      material,
      this.#all.length,
    );
    this.#all.forEach(({ color }, i) =>
      this.#mesh.setColorAt(i, new three.Color().fromArray(color)),
    );
    this.#scene.add(light, this.#mesh);
  }

  /** Milliseconds to hand over the poses, and to draw. */
  frame(): { write: number; tick: number } {
    posesAt((this.#time += 1 / 60), this.#all, this.#poses);
    const start = performance.now();
    this.#place();
    const written = performance.now();
    this.#renderer.render(this.#scene, this.#camera);
    return { write: written - start, tick: performance.now() - written };
  }

  #place(): void {
    const poses = this.#poses;
    const [place, turn, even] = [
      new three.Vector3(),
      new three.Quaternion(),
      new three.Vector3(1, 1, 1),
    ];
    const matrix = new three.Matrix4();
    for (let i = 0; i < this.#all.length; i++) {
      place.fromArray(poses, i * POSE);
      turn.fromArray(poses, i * POSE + 3);
      this.#mesh.setMatrixAt(i, matrix.compose(place, turn, even));
    }
    this.#mesh.instanceMatrix.needsUpdate = true;
  }
}
