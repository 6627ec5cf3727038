export const SCENE = `
  <x3d-rigid-body-collection id="collection">
    <x3d-rigid-body id="floor" fixed position="0 -0.5 0">
      <x3d-collidable-shape><shape><box size="10 1 10"></box></shape></x3d-collidable-shape>
    </x3d-rigid-body>
    <x3d-rigid-body id="stone" for="t" mass="2"></x3d-rigid-body>
    <x3d-ball-joint id="joint" body1="stone" anchorPoint="0 5 0"></x3d-ball-joint>
  </x3d-rigid-body-collection>
  <transform id="t" translation="0 0.5 0"><shape id="s"><box id="g" size="1 1 1"></box></shape></transform>`;
