// All particles once more: its emitter throws them whenever particles may be born anew.

interface System extends Element {
  createParticles: boolean;
  readonly world: { step(): void } | null;
}

export function burst({ currentTarget }: Event): void {
  const main = (currentTarget as Element).closest('main')!;
  const system = main.querySelector<System>('x3d-particle-system')!;
  system.createParticles = false;
  system.world?.step();
  system.createParticles = true;
}
