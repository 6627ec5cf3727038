// The page of Babylon.js: the fountain and nothing else.
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';
import '@babylonjs/core/Particles/particleSystemComponent.js';
import { babylonFountain } from '../babylon.js';
import { EYE } from '../fountain.js';

const { count, fades } = document.currentScript!.dataset;

const engine = new Engine(document.querySelector('canvas'));
const scene = new Scene(engine);
const camera = new FreeCamera('camera', new Vector3(EYE[0], EYE[1], -EYE[2]), scene);
camera.setTarget(new Vector3(0, EYE[1], 0));
const fountain = babylonFountain(scene, Number(count), fades === 'true');
engine.runRenderLoop(() => scene.render());
Object.assign(window, { fountain });
