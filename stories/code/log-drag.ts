// Writes who takes hold of a body, and how that ends, into a list beside the scene, the latest first.

const LINES = 12;

export function logDrag(event: Event): void {
  const { type, target, detail } = event as CustomEvent<{ by: string; reason?: string }>;
  const body = target as HTMLElement;
  const list = body.closest('main')!.querySelector('.log')!;
  const line = document.createElement('li');
  line.textContent =
    type === 'bodydragstart'
      ? `${body.title} is held (${detail.by})`
      : `${body.title} is let go (${detail.reason})`;
  list.prepend(line);
  while (list.children.length > LINES) list.lastElementChild!.remove();
}
