import 'x3dom/x3dom.css';
import './style.css';
import './x3dom.js';
import 'x3d-physics';

const [world, ball, count] = ['world', 'ball', 'count'].map((id) => document.getElementById(id));

document.getElementById('throw').addEventListener('click', () => {
  const motion = { linearVelocity: [9, 2.5, 0], angularVelocity: [0, 0, 0] };
  ball.teleport([-2.2, 1, 0], undefined, motion);
});

let hits = 0;
const show = () => (count.textContent = `${hits} hits`);

/** Boxes that the ball strikes, and not the floor. */
ball.addEventListener('collisionstart', ({ detail }) => {
  if (!detail.other.classList.contains('box')) return;
  hits++;
  show();
});

document.getElementById('again').addEventListener('click', () => {
  world.world.reset();
  hits = 0;
  show();
});
