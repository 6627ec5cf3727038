// Texts that the facts open.

const body = (id: string, x: number, attributes = '') => `  <transform translation="${x} 4 0">
    <shape><appearance><material diffuseColor="0.8 0.2 0.1"></material></appearance><box size="1 1 1"></box></shape>
    <x3d-rigid-body id="${id}" ${attributes}></x3d-rigid-body>
  </transform>`;

export const A = body('a', -2, 'mass="2" angularVelocity="1 2 0"');
export const B = body('b', 0);
export const C = body('c', 2);
export const NEW = body('new', 4);

const GROUND = `  <transform translation="0 -0.5 0">
    <shape><box size="20 1 20"></box></shape>
    <x3d-rigid-body id="ground" fixed></x3d-rigid-body>
  </transform>`;

/** Three falling boxes over a floor. */
export const BOXES = `<scene>
${A}
${B}
${C}
${GROUND}
  <!-- a word -->
</scene>`;

/** The same in X3D's own tags. */
export const PLAIN = `<X3D><Scene>
  <Transform translation="0 4 0">
    <Shape><Box size="1 1 1"/></Shape>
    <RigidBody DEF="a" mass="2"/>
  </Transform>
</Scene></X3D>`;

/** Two scripts: one counts steps, one is a module that knows the package by its name. */
export const COUNTING = `<x3d>
${BOXES}
</x3d>
<p>Steps: <output></output> <button>Kick</button></p>
<script>
  let count = 0;
  window.begun = Math.random();
  const a = document.getElementById('a');
  document.addEventListener('afterstep', () => (document.querySelector('output').textContent = ++count));
  document.querySelector('button').onclick = () => a.applyImpulse([0, 20, 0]);
</script>
<script type="module">
  import { worldOf } from 'x3d-physics';
  const world = worldOf(document.getElementById('a'));
  setInterval(() => (window.fromModule = world.time), 50);
</script>`;
