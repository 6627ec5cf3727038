// After each step: a body that has come down begins again where its markup says.

interface Body extends Element {
  readonly position: number[];
  linearVelocity: number[];
  angularVelocity: number[];
  teleport(position: number[]): void;
}

/** Metres. */
const DOWN = 0.45;

export function startOver({ currentTarget }: Event): void {
  const scene = (currentTarget as Element).closest('scene')!;
  for (const body of scene.querySelectorAll<Body>('.returns')) {
    if (body.position[1]! > DOWN) continue;
    body.teleport(body.getAttribute('position')!.split(' ').map(Number));
    body.linearVelocity = [0, 0, 0];
    body.angularVelocity = [0, 0, 0];
  }
}
