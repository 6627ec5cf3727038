// Takes all particles away, and has its emitter throw them once more.

interface System extends Element {
  enabled: boolean;
  readonly world: { step(): void } | null;
}

export function burst({ currentTarget }: Event): void {
  const main = (currentTarget as Element).closest('main')!;
  const system = main.querySelector<System>('x3d-particle-system')!;
  system.enabled = false;
  system.world?.step();
  system.enabled = true;
}
