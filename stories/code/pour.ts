// Boxes poured into the scene, and what accuracy auto says when it changes the level for them.
interface Change extends Event {
  readonly detail: { level: string; from: string; because: string; p90?: number };
}

const BATCH = 40;

let poured = 0;

function box(): Element {
  const transform = document.createElement('transform');
  const size = 0.3 + 0.02 * (poured % 10);
  const at = [((poured * 7) % 9) / 4 - 1, 3 + (poured % BATCH) / 6, ((poured * 5) % 7) / 4 - 0.75];
  poured++;
  transform.setAttribute('translation', at.join(' '));
  transform.innerHTML = `<shape><appearance><material diffuseColor="0.1 0.5 0.65"></material></appearance>
    <box size="${size} ${size} ${size}"></box></shape><x3d-rigid-body mass="${8 * size ** 3}"></x3d-rigid-body>`;
  return transform;
}

export function pour({ currentTarget }: Event): void {
  const scene = (currentTarget as Element).closest('main')!.querySelector('scene')!;
  for (let i = 0; i < BATCH; i++) scene.append(box());
}

export function tellLevel(event: Event): void {
  const { level, from, because, p90 } = (event as Change).detail;
  const list = (event.currentTarget as Element).closest('main')!.querySelector('.log')!;
  const line = document.createElement('li');
  const cost = p90 === undefined ? '' : `, nine frames in ten below ${p90.toFixed(1)} ms`;
  line.textContent = `${from} → ${level}: ${because}${cost}`;
  list.prepend(line);
}
