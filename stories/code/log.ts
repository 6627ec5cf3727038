// Writes what the bodies tell into a list beside the scene, the latest first.

interface Told extends Event {
  readonly detail: { other?: Element; impulse?: number; time: number; reason?: string };
}

const LINES = 12;

const SENTENCES: Record<string, (told: Told['detail']) => string> = {
  collisionstart: ({ other, impulse }) => `touches ${other?.id}, ${(impulse ?? 0).toFixed(1)} N·s`,
  collisionend: ({ other, reason }) => `leaves ${other?.id} (${reason})`,
  sleep: () => 'sleeps',
  wake: () => 'wakes',
};

export function log(event: Event): void {
  const { type, target, detail } = event as Told;
  const body = target as Element;
  const list = body.closest('main')!.querySelector('.log')!;
  const line = document.createElement('li');
  line.textContent = `${detail.time.toFixed(2)} s: ${body.id} ${SENTENCES[type]!(detail)}`;
  list.prepend(line);
  while (list.children.length > LINES) list.lastElementChild!.remove();
}
