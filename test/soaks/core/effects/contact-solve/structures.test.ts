import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  position,
  velocity,
  world,
} from '../../../../core/helpers.js';
import {
  arch,
  borne,
  cards,
  farthest,
  G,
  stack,
  standing,
} from '../../../../core/effects/contact-solve/scenes.js';

// What bears others: what leans, what is wedged in, and what is carried along.

fact('a card house of three storeys moves by less than 1 mm in ten seconds', async () => {
  below(farthest(await standing(cards(), { accuracy: 'fine' }), 10), 1e-3, 'm');
});

fact('an arch of 13 wedges moves by less than 1 mm in ten seconds', async () => {
  below(farthest(await standing(arch(13), { accuracy: 'fine' }), 10), 1e-3, 'm');
});

fact('what a stack lies on bears its weight, and each in it what is above', async () => {
  for (const count of [1, 5, 10]) {
    const { w, floor, bodies } = await standing(stack(count, 1, (i) => ({ mass: 1 + i })));
    w.advance(2);
    bodies.forEach((body, i) => {
      let mass = 0;
      for (let k = i; k < count; k++) mass += 1 + k;
      const weight = borne(w, body, bodies[i - 1] ?? floor);
      close(weight / (mass * G), 1, 1e-3, `of the weight from ${i} on`);
    });
  }
});

fact('what its author moves pushes a stack along as it goes itself', async () => {
  const { w, bodies } = await standing(stack(4));
  const place = (t: number) => [0.25 * (1 - Math.cos(t)) - 1, 0.4, 0];
  const geometry = [box(1, 0.6, 1)];
  const pusher = addBody(w, { fixed: true, position: place(0), geometry });
  for (let i = 1; i <= 360; i++) {
    pusher.set('position', place(i * w.timeStep));
    w.step();
  }
  const way = place(360 * w.timeStep)[0]! + 1;
  bodies.forEach((body, i) => close(position(body), [way, 0.5 + i, 0], 1e-3, `box ${i}`));
});

fact('a stack on a lift rides with it, up and down', async () => {
  const w = await world();
  const lift = addFloor(w);
  const bodies = stack(5).map((one) => addBody(w, one));
  w.advance(0.5);
  const before = bodies.map(position);
  const height = (t: number) => 0.3 * (1 - Math.cos(2 * t));
  for (let i = 1; i <= 600; i++) {
    lift.set('position', [0, height(i * w.timeStep) - 0.5, 0]);
    w.step();
  }
  const rise = height(600 * w.timeStep);
  bodies.forEach((body, i) => {
    const [x, y, z] = before[i]!;
    close(position(body), [x, y + rise, z], 1e-3, `box ${i}`);
    close(velocity(body)[1], 0.6 * Math.sin(2 * 600 * w.timeStep), 0.02, 'm/s');
  });
});
