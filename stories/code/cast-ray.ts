// After each step: asks what the beam meets, draws it as far as that, and lights up what it met.

const FROM = [-5, 1.3, 0];
const TO = [5, 1.3, 0];

interface Collection extends Element {
  readonly world: {
    raycast(from: number[], to: number[]): { node: { host: unknown }; fraction: number } | null;
  } | null;
}

export function castRay({ currentTarget }: Event): void {
  const collection = currentTarget as Collection;
  const main = collection.closest('main')!;
  const hit = collection.world?.raycast(FROM, TO) ?? null;
  const length = (TO[0]! - FROM[0]!) * (hit?.fraction ?? 1);
  const beam = main.querySelector('#beam')!;
  beam.setAttribute('translation', `${FROM[0]! + length / 2} ${FROM[1]} 0`);
  beam.setAttribute('scale', `${length} 1 1`);
  for (const plate of main.querySelectorAll('.plate')) {
    const met = plate.querySelector('x3d-rigid-body') === hit?.node.host;
    const material = plate.querySelector('material')!;
    const color = met ? '0.9 0.1 0.1' : '0 0 0';
    if (material.getAttribute('emissiveColor') !== color)
      material.setAttribute('emissiveColor', color);
  }
}
