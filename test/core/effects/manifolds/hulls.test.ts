import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  height,
  position,
  velocity,
  WEIGHTLESS,
  world,
} from '../../helpers.js';

// A hull touches with its faces, edges and corners as they are drawn: Bullet would keep a margin around them.

const G = 9.81;

/** A cube as points and faces. */
const cube = (size: number) => {
  const h = size / 2;
  return {
    type: 'IndexedFaceSet',
    coord: [-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1].map(
      (s) => s * h,
    ),
    coordIndex: [
      0, 3, 2, 1, -1, 4, 5, 6, 7, -1, 0, 1, 5, 4, -1, 1, 2, 6, 5, -1, 2, 3, 7, 6, -1, 3, 0, 4, 7,
      -1,
    ],
  };
};

fact('two hulls that touch without gravity stay where they are', async () => {
  const w = await world(WEIGHTLESS);
  const pair = [-0.5, 0.5].map((x) => addBody(w, { position: [x, 0, 0], geometry: [cube(1)] }));
  w.advance(2);
  for (const body of pair) close(velocity(body), [0, 0, 0], 1e-5);
  close(position(pair[1]!)[0] - position(pair[0]!)[0], 1, 1e-4);
});

fact(
  'what a hull is made of is read when it comes, not in the step of its first touch',
  async () => {
    const w = await world();
    addFloor(w);
    const body = addBody(w, { position: [0, 0.7, 0], geometry: [cube(1)] });
    w.step(0);
    let reads = 0;
    const [{ outline }] = body.solidParts as unknown as [{ outline: { hull: unknown } }];
    const { hull } = outline;
    Object.defineProperty(outline, 'hull', { get: () => (reads++, hull) });
    w.advance(1);
    close(height(body), 0.5, 1e-4);
    close(reads, 0, 0);
  },
);

fact('a stack of hulls stands as high as its hulls are', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  const stack = [0.5, 1.5, 2.5].map((y) =>
    addBody(w, { position: [0, y, 0], geometry: [cube(1)] }),
  );
  w.advance(5);
  stack.forEach((body, i) => {
    close(height(body), i + 0.5, 1e-3, `height of hull ${i}`);
    below(Math.hypot(...velocity(body)), 1e-3, `speed of hull ${i}`);
  });
});

fact('a hull that falls on a corner comes to lie on a face', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  const body = addBody(w, {
    position: [0, 1.2, 0],
    orientation: [1, 2, 3, 0.8],
    geometry: [cube(1)],
  });
  w.advance(8);
  close(height(body), 0.5, 5e-4);
});

fact('a hull slides down a slope as a box does', async () => {
  const tilt = 0.5;
  const slides = await Promise.all(
    [cube(0.5), box(0.5)].map(async (geometry) => {
      const w = await world({ gravity: [G * Math.sin(tilt), -G * Math.cos(tilt), 0] });
      addFloor(w);
      const body = addBody(w, { position: [0, 0.25, 0], geometry: [geometry] });
      w.advance(2);
      return position(body)[0];
    }),
  );
  // a = g (sin 0.5 - 0.5 cos 0.5)
  close(slides[0]!, 0.5 * G * (Math.sin(tilt) - 0.5 * Math.cos(tilt)) * 4, 0.02);
  close(slides[0]!, slides[1]!, 0.01);
});
