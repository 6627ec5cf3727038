/* global document, performance, requestAnimationFrame */
// What a running scene costs, as a small list upon it.

/** How often the numbers change, milliseconds: often enough to follow, seldom enough to read. */
const INTERVAL = 500;

/** Milliseconds that x3dom's own script takes to draw, summed since the last `take`. */
function renderClock(runtime) {
  let sum = 0;
  let entered = 0;
  runtime.enterFrame = () => (entered = performance.now());
  runtime.exitFrame = () => (sum += performance.now() - entered);
  return {
    take() {
      const taken = sum;
      sum = 0;
      return taken;
    },
  };
}

const whole = new Intl.NumberFormat('en');
const milliseconds = (value) => `${value.toFixed(1)} ms`;

/** A list of terms; answers what sets their values. */
function list(names) {
  const element = document.createElement('dl');
  element.className = 'stats';
  element.setAttribute('aria-label', 'Statistics');
  element.setAttribute('aria-live', 'off');
  const values = names.map((name) => {
    const term = document.createElement('dt');
    const value = document.createElement('dd');
    term.textContent = name;
    value.textContent = '–';
    element.append(term, value);
    return value;
  });
  return { element, set: (texts) => texts.forEach((text, i) => (values[i].textContent = text)) };
}

/** Shows the numbers of a world beside its x3d element for as long as that stands in the page. */
export function showStats(x3d, world) {
  const { element, set } = list([
    'Bodies',
    'Awake',
    'Joints',
    'Frame rate',
    'Physics',
    'Rendering',
  ]);
  x3d.after(element);
  const render = renderClock(x3d.runtime);
  let frames = 0;
  let physics = 0;
  let since = performance.now();

  const show = (seconds) => {
    const { bodies, awake, joints } = world.stats;
    set([
      ...[bodies, awake, joints].map((count) => whole.format(count)),
      `${Math.round(frames / seconds)} fps`,
      milliseconds(physics / frames),
      milliseconds(render.take() / frames),
    ]);
    frames = physics = 0;
  };

  const frame = (now) => {
    if (!x3d.isConnected) return;
    const { step, read, write, events } = world.stats.ms;
    frames++;
    physics += step + read + write + events;
    if (now - since >= INTERVAL) {
      show((now - since) / 1000);
      since = now;
    }
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
