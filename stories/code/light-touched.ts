// After each step: what the sensor sees touching lights up, and its contacts are counted.

interface Sensor extends Element {
  readonly intersections: Element[];
  readonly contacts: object[];
}

export function lightTouched({ currentTarget }: Event): void {
  const main = (currentTarget as Element).closest('main')!;
  const sensor = main.querySelector<Sensor>('x3d-collision-sensor')!;
  const touched = new Set(sensor.intersections);
  for (const plate of main.querySelectorAll('.plate')) {
    const color = touched.has(plate) ? '0.8 0.35 0' : '0 0 0';
    const material = plate.querySelector('material')!;
    if (material.getAttribute('emissiveColor') !== color)
      material.setAttribute('emissiveColor', color);
  }
  main.querySelector('output')!.textContent = String(sensor.contacts.length);
}
