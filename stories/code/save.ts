// Saves a world, throws a ball into it, and puts everything back.

interface World {
  readonly time: number;
  snapshot(): object;
  restore(snapshot: object): void;
}

interface Body extends Element {
  readonly world: World | null;
  linearVelocity: number[];
  teleport(position: number[]): void;
}

let saved: object | undefined;

const mainOf = ({ currentTarget }: Event) => (currentTarget as Element).closest('main')!;
const ballOf = (event: Event) => mainOf(event).querySelector<Body>('#ball')!;

export function save(event: Event): void {
  const world = ballOf(event).world!;
  saved = world.snapshot();
  mainOf(event).querySelector('output')!.textContent = `Saved at ${world.time.toFixed(1)} s.`;
}

export function throwBall(event: Event): void {
  const ball = ballOf(event);
  ball.teleport([-5, 1.2, 0]);
  ball.linearVelocity = [14, 1.5, 0];
}

export function putBack(event: Event): void {
  if (saved) ballOf(event).world!.restore(saved);
}
