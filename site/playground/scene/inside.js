// Runs in the scene's page, before any script of the text: makes the page's elements, does the edits that come from the
// playground, and tells it how the scene is. Read as text (`?raw`) and put into the page: the page is in a sandbox, where
// neither side sees into the other, and may import nothing.
/* global addEventListener, document, MessageChannel, parent, performance, window */
(() => {
  const { nonce, library, ownTags, roots, paused: isPaused, panel, scheme } = given();
  const { port1: port, port2 } = new MessageChannel();
  const own = new Set(ownTags);
  /** What stands in the text, by the numbers that the playground gave. */
  const nodes = new Map();
  const numbers = new WeakMap();
  /** Problems of elements that no world has, for instance outside any scene. */
  const strays = new Set();
  let paused = isPaused;
  let done = 0;
  /** Whether worlds are recorded, those that come later, too. */
  let recording = false;

  /** Milliseconds between two looks at the worlds. */
  const LOOK = 250;
  /** Milliseconds for which a run waits for worlds. */
  const PATIENCE = 5000;
  /** Simulated seconds that are recorded: of a thousand bodies they take some 100 MB. */
  const SECONDS = 30;
  /** What leads to every world: its collections, and what may stand outside any. */
  const IN_WORLDS =
    'x3d, inline, x3d-rigid-body-collection, rigidbodycollection, x3d-rigid-body, rigidbody';

  function given() {
    const script = document.getElementById('given');
    const value = JSON.parse(script.textContent);
    script.remove();
    document.currentScript.remove();
    return value;
  }

  // ---- elements ------------------------------------------------------------------------------------------------------

  /** The whole of it before it comes into the page. */
  function make(made) {
    const node = made.tag === undefined ? document.createTextNode(made.text) : element(made);
    nodes.set(made.id, node);
    numbers.set(node, made.id);
    return node;
  }

  function element({ id, tag, attributes, children }) {
    const node = document.createElement(tag);
    for (const [name, value] of attributes) node.setAttribute(name, value);
    (node.content ?? node).append(...children.map(make));
    if (node.localName === 'script') asScript(node, id);
    return node;
  }

  /** In the order of the text; an error names it by its number. */
  function asScript(script, id) {
    script.nonce = nonce;
    script.async = script.hasAttribute('async');
    if (!script.src && !/map|json/.test(script.type))
      script.append(`\n//# sourceURL=script-${id}.js`);
  }

  /** Fields of a node and their defaults; none where x3dom makes no node without an element. */
  function fieldsOf(tag) {
    try {
      return Object.entries(new window.x3dom.nodeTypesLC[tag.toLowerCase()]()._vf);
    } catch {
      return [];
    }
  }

  /** What x3dom takes where an element of its own has no such attribute; null where that is no field of it. */
  function defaultOf({ localName }, attribute) {
    const key = attribute.toLowerCase();
    const field = fieldsOf(localName).find(([name]) => name.toLowerCase() === key);
    return field ? String(field[1] ?? '') : null;
  }

  const edits = {
    remove: ({ id }) => nodes.get(id).remove(),
    write: ({ id, text }) => (nodes.get(id).textContent = text),
    replace: ({ id, made }) => nodes.get(id).replaceWith(make(made)),
    place({ id, parent, before, made }) {
      const container = parent === null ? document.body : nodes.get(parent);
      container.insertBefore(
        made ? make(made) : nodes.get(id),
        before === null ? null : nodes.get(before),
      );
    },
    /** The library's own elements follow every edit; x3dom does not see that an attribute goes. */
    set({ id, name, value }) {
      const node = nodes.get(id);
      const now = value ?? (own.has(node.localName) ? null : defaultOf(node, name));
      if (now === null) node.removeAttribute(name);
      else node.setAttribute(name, now);
    },
  };

  // ---- worlds --------------------------------------------------------------------------------------------------------

  function worlds() {
    const all = [...document.body.querySelectorAll(IN_WORLDS)].map((each) => window.worldOf(each));
    return [...new Set(all)].filter(Boolean);
  }

  function pause(on) {
    paused = on;
    for (const world of worlds()) world.paused = on;
  }

  // ---- what is recorded ----------------------------------------------------------------------------------------------

  function record() {
    // What a world can't start for is told by itself.
    for (const world of worlds())
      if (!world.timeline) world.record({ seconds: SECONDS }).catch(() => {});
  }

  const timelines = () => worlds().flatMap(({ timeline }) => timeline ?? []);

  /** Without its markup: that is the text's. */
  const runOf = (world) => ({ ...world.exportRun(), markup: undefined });

  /** All worlds of a scene come at once. */
  async function startedWorlds() {
    const end = performance.now() + PATIENCE;
    while (worlds().length === 0 && performance.now() < end)
      await new Promise((go) => setTimeout(go, LOOK / 10));
    const all = worlds();
    await Promise.allSettled(all.map(({ ready }) => ready));
    return all;
  }

  /** Runs anew what was recorded, and stands at its beginning; answers why it does not. */
  async function show(runs) {
    const all = await startedWorlds();
    if (all.length !== runs.length) return 'This run is of another scene: that has other worlds.';
    for (const world of all) world.paused = true;
    const shown = await Promise.all(
      all.map((world, i) => world.importRun(runs[i]).catch(() => {})),
    );
    pause(paused);
    for (const timeline of shown) timeline?.seek(timeline.from);
    recording = shown.every(Boolean);
    if (recording) return undefined;
    const problems = all.flatMap((world) => world.problems);
    const refused = problems.find(({ attribute }) => attribute === 'importRun');
    return refused?.message ?? 'The scene has not started.';
  }

  // ---- what is wrong -------------------------------------------------------------------------------------------------

  /** A problem names its element, or the name of a node that has none. */
  const elementOf = ({ element: of }) => (typeof of === 'object' ? of : null);

  /** Its state says whether it is still so. */
  function standingStrays(inWorlds) {
    for (const stray of strays) {
      const of = elementOf(stray);
      const isInWorld = inWorlds.some(({ message }) => message === stray.message);
      if (isInWorld || !of?.isConnected || !of.matches(':state(problem)')) strays.delete(stray);
    }
    return [...strays];
  }

  /** Of an element, what says it in the text: itself or what it stands in. */
  function sourceOf(of) {
    for (let at = of; at; at = at.parentElement) if (numbers.has(at)) return numbers.get(at);
    return null;
  }

  const plain = (problem) => ({
    code: problem.code,
    severity: problem.severity,
    message: problem.message,
    attribute: problem.attribute ?? null,
    source: sourceOf(elementOf(problem)),
  });

  let told = '';

  function tell() {
    const all = worlds();
    const inWorlds = all.flatMap(({ problems }) => problems);
    const problems = [...inWorlds, ...standingStrays(inWorlds)].map(plain);
    const time = Math.max(0, ...all.map((world) => world.timeline?.at ?? world.time));
    const playing = timelines().some((timeline) => timeline.playing);
    const state = { time, problems, recording, playing, done };
    const now = JSON.stringify(state);
    if (now !== told) port.postMessage({ state });
    told = now;
  }

  // ---- the panel -----------------------------------------------------------------------------------------------------

  let aside;

  /** Beside the body, so that scripts of the text find nothing in it that they did not write. */
  function showPanel(open) {
    aside?.remove();
    aside = open ? document.createElement('aside') : undefined;
    if (!aside) return;
    aside.append(
      document.createElement('x3d-physics-monitor'),
      document.createElement('x3d-accuracy-chart'),
    );
    document.documentElement.append(aside);
  }

  // ---- what the playground asks --------------------------------------------------------------------------------------

  const NO_TAG = /^X3D|^[a-z_]/;

  const asked = {
    edit(list) {
      for (const edit of list) edits[edit.do](edit);
      pause(paused);
    },
    clear() {
      recording = false;
      document.body.replaceChildren();
    },
    pause,
    step() {
      pause(true);
      for (const world of worlds()) world.step(1);
    },
    record(on) {
      recording = on;
      if (on) record();
      else for (const timeline of timelines()) timeline.stop();
    },
    play(on) {
      for (const timeline of timelines()) timeline[on ? 'play' : 'pause']();
    },
    runs: () =>
      worlds()
        .filter(({ timeline }) => timeline)
        .map(runOf),
    show,
    panel: showPanel,
    scheme: (scheme) => (document.documentElement.style.colorScheme = scheme),
    /** Tags in lower case, nodes in X3D's case with their fields as text. */
    words() {
      const { nodeTypes, nodeTypesLC } = window.x3dom;
      const named = Object.keys(nodeTypes).filter((name) => !NO_TAG.test(name));
      const asText = ([name, value]) => [name, String(value ?? '')];
      const all = named.map((name) => [name, fieldsOf(name).map(asText)]);
      return { tags: Object.keys(nodeTypesLC), nodes: all };
    },
  };

  async function answer(number, value) {
    port.postMessage({ answer: { number, value: await value } });
    tell();
  }

  port.onmessage = ({ data }) => {
    for (const { ask, what, number } of data) {
      const value = asked[ask](what);
      done = number;
      if (value !== undefined) void answer(number, value);
    }
    tell();
  };

  /** Runs are dropped on the scene, too. */
  addEventListener('dragover', (event) => {
    if (event.dataTransfer.types.includes('Files')) event.preventDefault();
  });
  addEventListener('drop', (event) => {
    const [file] = event.dataTransfer.files;
    if (!file) return;
    event.preventDefault();
    port.postMessage({ file });
  });

  // ---- the start -----------------------------------------------------------------------------------------------------

  const NAMED = /script-(\d+)\.js/;

  function fault(message, file, line) {
    const [, id] = NAMED.exec(file ?? '') ?? [];
    port.postMessage({ fault: { message: String(message), id: id ? Number(id) : null, line } });
  }

  addEventListener('error', ({ message, filename, lineno }) => fault(message, filename, lineno));
  addEventListener('unhandledrejection', ({ reason }) => {
    const [, line] = /script-\d+\.js:(\d+)/.exec(reason?.stack ?? '') ?? [];
    fault(`Uncaught (in promise) ${reason}`, reason?.stack, line ? Number(line) : 0);
  });

  /** So that modules of the text find the package by its name, as in a page with an import map. */
  function nameLibrary() {
    const names = Object.keys(window.X3DPhysics).filter((name) => /^\w+$/.test(name));
    const text = `export const { ${names.join(', ')} } = globalThis.X3DPhysics;`;
    const map = document.createElement('script');
    Object.assign(map, { type: 'importmap', nonce });
    map.text = JSON.stringify({
      imports: { 'x3d-physics': `data:text/javascript,${encodeURIComponent(text)}` },
    });
    document.head.append(map);
  }

  const missing = window.x3dom ? !window.X3DPhysics && library : 'x3dom';
  parent.postMessage({ missing: missing || null }, '*', [port2]);
  if (missing) return;
  nameLibrary();
  asked.scheme(scheme);
  window.worldOf = window.X3DPhysics.worldOf;
  // A world that comes later waits, and is recorded, as the others are.
  document.addEventListener('physicsready', () => {
    pause(paused);
    if (recording) record();
  });
  document.addEventListener('physicsproblem', ({ detail }) => strays.add(detail));
  // One by one: a script finds what stands above it.
  for (const root of roots) document.body.append(make(root));
  showPanel(panel);
  setInterval(tell, LOOK);
})();
