// Takes two worlds through the same 60ths of a second, and writes down how far they are apart and what each costs.
type World = NonNullable<HTMLElementTagNameMap['x3d-rigid-body']['world']>;

export const LEVELS = ['game', 'standard', 'fine', 'precise', 'reference'] as const;

const MOMENT = 1 / 60;

/** Weight of the newest moment in the running mean of what a level costs. */
const NEWEST = 0.02;

/** Metres that tell them apart at a glance. */
const APART = 0.1;

interface Runner {
  world: World;
  /** Its last ball. */
  end: HTMLElementTagNameMap['x3d-rigid-body'] & { readonly position: readonly number[] };
  /** Milliseconds per simulated second. */
  cost: number;
}

const runner = (main: Element, id: string): Runner => {
  const end = main.querySelector<Runner['end']>(`#${id} .end`)!;
  return { world: end.world!, end, cost: 0 };
};

function advance(one: Runner): void {
  const start = performance.now();
  one.world.advance(MOMENT);
  const cost = (performance.now() - start) / MOMENT;
  one.cost += (cost - one.cost) * (one.cost ? NEWEST : 1);
}

function metres(value: number): string {
  if (value >= 0.1) return `${value.toFixed(2)} m`;
  return value >= 1e-3 ? `${(value * 1e3).toFixed(1)} mm` : `${(value * 1e6).toFixed(0)} µm`;
}

const seconds = (value: number): string => `${value.toFixed(1)} s`;

/** When both worlds have started. */
export async function besideReference(event: Event): Promise<void> {
  const main = (event.currentTarget as Element).closest('main')!;
  const [level, ghost] = [runner(main, 'level'), runner(main, 'ghost')];
  await Promise.all([level.world.ready, ghost.world.ready]);
  /** When they came apart. */
  let parted: number | undefined;
  let shown = 0;
  const write = (name: string, text: string): void => {
    main.querySelector(`[data-value=${name}]`)!.textContent = text;
  };

  function again(): void {
    const slider = main.querySelector<HTMLInputElement>('input[type=range]')!;
    level.world.accuracy = LEVELS[Number(slider.value)]!;
    slider.setAttribute('aria-valuetext', level.world.accuracy);
    level.cost = 0;
    for (const { world } of [level, ghost]) {
      world.paused = true;
      world.reset();
    }
    write('level', `${level.world.accuracy}, 1/${Math.round(1 / level.world.timeStep)} s`);
  }

  function show(): void {
    const [a, b] = [level.end.position, ghost.end.position];
    const apart = Math.hypot(...a.map((x, i) => x - b[i]!));
    const { time } = level.world;
    // The button starts the scene again.
    if (time < shown) parted = undefined;
    if (apart > APART) parted ??= time;
    shown = time;
    write('time', seconds(time));
    write('drift', metres(apart));
    write('together', parted === undefined ? 'so far' : seconds(parted));
    write('cost', `${level.cost.toFixed(1)} ms per s`);
    write('ghost', `${ghost.cost.toFixed(1)} ms per s`);
  }

  let before = performance.now();
  function frame(now: number): void {
    if (!main.isConnected) return;
    const moments = Math.min(6, Math.floor((now - before) / 1000 / MOMENT + 0.1));
    before = moments === 6 ? now : before + moments * MOMENT * 1000;
    for (let i = 0; i < moments; i++) for (const one of [level, ghost]) advance(one);
    if (moments > 0) show();
    requestAnimationFrame(frame);
  }

  main.querySelector('input[type=range]')!.addEventListener('input', again);
  again();
  requestAnimationFrame(frame);
}
