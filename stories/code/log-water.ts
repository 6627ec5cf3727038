// Writes what comes into the water and leaves it into a list beside the scene, the latest first.

interface Told extends Event {
  readonly detail: { speed: number; time: number };
}

const LINES = 8;

export function logWater(event: Event): void {
  const { type, target, detail } = event as Told;
  const body = target as Element;
  const list = body.closest('main')!.querySelector('.log')!;
  const line = document.createElement('li');
  const does = type === 'waterenter' ? 'comes in' : 'leaves';
  const speed = Math.abs(detail.speed).toFixed(1);
  line.textContent = `${detail.time.toFixed(2)} s: ${body.id} ${does}, ${speed} m/s`;
  list.prepend(line);
  while (list.children.length > LINES) list.lastElementChild!.remove();
}
