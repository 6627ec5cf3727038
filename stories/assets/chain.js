// Scene 4: a chain that lies on the ground grows at its end, link by link.
import { grow } from './grow.js';

/** Metres from link to link. */
const PITCH = 0.5;
/** Metres from one round of the spiral to the next. */
const ROUND = 1;
/** Sideways speed of a new link, m/s: enough to see it slide, too little to reach the next round of the spiral. */
const SPEED = 0.3;

/** Where a chain of `n` links lies on Archimedes' spiral: its radius there. */
const radius = (n) => Math.sqrt((n * PITCH * ROUND) / Math.PI + 1);

// In micrometres: what a link is placed off by, its hinge then pulls at.
const text = (...numbers) => numbers.map((number) => number.toFixed(6)).join(' ');

export function growChain(x3d) {
  const scene = x3d.querySelector('scene, Scene');
  let last = 'link0';
  grow(x3d, (copy, number, world) => {
    const [x, y, z] = world.node(last).get('position');
    const [, up, , angle] = world.node(last).get('orientation');
    const heading = (up < 0 ? -angle : angle) + PITCH / radius(number);
    const ahead = [Math.cos(heading), -Math.sin(heading)];
    const name = `link${number}`;
    const at = (distance) => text(x + distance * ahead[0], y, z + distance * ahead[1]);

    const [link, joint] = copy.children;
    link.setAttribute('translation', at(PITCH));
    link.setAttribute('rotation', text(0, 1, 0, heading));
    const body = link.querySelector('x3d-rigid-body, RigidBody');
    body.setAttribute('id', name);
    const aside = (number % 2 ? 1 : -1) * SPEED;
    body.setAttribute('linearVelocity', text(-aside * ahead[1], 0, aside * ahead[0]));
    joint.setAttribute('body1', last);
    joint.setAttribute('body2', name);
    joint.setAttribute('anchorPoint', at(PITCH / 2));
    scene.append(copy);
    last = name;
  });
}
