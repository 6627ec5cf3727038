// Scene 3: boxes fall into a room until it is full.
import { grow, sequence } from './grow.js';

/** kg/m³: light enough for the ball to stir. */
const DENSITY = 2;
const COLORS = [
  '0.82 0.28 0.2',
  '0.9 0.66 0.25',
  '0.25 0.58 0.6',
  '0.22 0.36 0.55',
  '0.86 0.83 0.76',
];

export function fillRoom(x3d) {
  const scene = x3d.querySelector('scene, Scene');
  const random = sequence();
  grow(x3d, (box, number) => {
    const size = 0.5 + 0.5 * random();
    const transform = box.firstElementChild;
    transform.setAttribute('translation', `${6 * random() - 3} 8.5 ${6 * random() - 3}`);
    transform.querySelector('box, Box').setAttribute('size', `${size} ${size} ${size}`);
    transform
      .querySelector('material, Material')
      .setAttribute('diffuseColor', COLORS[number % COLORS.length]);
    transform
      .querySelector('x3d-rigid-body, RigidBody')
      .setAttribute('mass', String(DENSITY * size ** 3));
    scene.append(box);
  });
}
