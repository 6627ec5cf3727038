// After each step: a car that fell off the ground starts again.

interface Car extends Element {
  readonly position: number[];
  readonly world: { reset(): void } | null;
}

export function restartFallen({ currentTarget }: Event): void {
  const car = (currentTarget as Element).closest('scene')!.querySelector<Car>('#car')!;
  if (car.position[1]! < -3) car.world?.reset();
}
