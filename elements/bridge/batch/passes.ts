import type { X3DRenderer } from '../x3dom/renderer.js';
import type { X3DMatrix } from '../x3dom/x3dom.js';

export type Pass = 'picture' | 'shadow' | 'pick';

/** The maps of shadows that a frame needs come after the picture and what is under the pointer. */
const PICTURE = 0;
const PICK = 1;
const MAPS = 2;

/** What x3dom draws all Shapes for at the moment, and from where: it says so where it begins. */
export class Passes {
  pass: Pass = 'picture';
  /** Of all that x3dom draws in a frame. */
  index = PICTURE;
  /** From the world to the eye. */
  view: X3DMatrix | undefined;
  /** From the world to the picture. */
  scene: X3DMatrix | undefined;
  #maps = 0;
  readonly #renderer: X3DRenderer;

  constructor(renderer: X3DRenderer, beforeFrame: () => void) {
    this.#renderer = renderer;
    const { renderScene, renderShape, renderShadowPass, renderPickingPass } = renderer;
    renderer.renderScene = (...args) => {
      this.#maps = 0;
      beforeFrame();
      renderScene.apply(renderer, args);
    };
    renderer.renderShape = (drawable, area, lights, count, view, scene, ...rest) => {
      this.#begin('picture', PICTURE, view, scene);
      renderShape.call(renderer, drawable, area, lights, count, view, scene, ...rest);
    };
    renderer.renderShadowPass = (gl, area, scene, view, ...rest) => {
      this.#begin('shadow', MAPS + this.#maps++, view, scene);
      renderShadowPass.call(renderer, gl, area, scene, view, ...rest);
    };
    renderer.renderPickingPass = (gl, all, view, scene, ...rest) => {
      this.#begin('pick', PICK, view, scene);
      renderPickingPass.call(renderer, gl, all, view, scene, ...rest);
    };
  }

  #begin(pass: Pass, index: number, view: X3DMatrix, scene: X3DMatrix): void {
    this.pass = pass;
    this.index = index;
    this.view = view;
    this.scene = scene;
  }

  /** x3dom's own methods again. */
  unhook(): void {
    const names = ['renderScene', 'renderShape', 'renderShadowPass', 'renderPickingPass'];
    for (const name of names) Reflect.deleteProperty(this.#renderer, name);
  }
}
