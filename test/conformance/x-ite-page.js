// In the page that holds X_ITE, before X_ITE: its clock and frames are ours, so that a second is sixty frames exactly.
// Then `conformance` shows scenes there and reads and writes their fields by X3D's scene access interface.
(() => {
  const page = globalThis;
  const FRAME = 1000 / 60;
  let now = 1.8e12;
  let callbacks = new Map();
  let next = 1;
  page.Date.now = () => now;
  page.performance.now = () => now;
  page.requestAnimationFrame = (callback) => {
    callbacks.set(next, callback);
    return next++;
  };
  page.cancelAnimationFrame = (id) => callbacks.delete(id);

  function drawFrame() {
    now += FRAME;
    const due = [...callbacks.values()];
    callbacks = new Map();
    for (const callback of due) callback(now);
  }

  let browser;
  let scene;

  /** Frames are drawn until the promise resolves. */
  async function drawing(promise) {
    const timer = page.setInterval(drawFrame, 1);
    try {
      return await promise;
    } finally {
      page.clearInterval(timer);
    }
  }

  let loading = true;
  const EMPTY =
    '<X3D profile="Full" version="4.0"><Scene><RigidBodyCollection DEF="c"/></Scene></X3D>';

  /**
   * No collection moves its bodies while its scene is still loading, nor begins with X_ITE's fifteen frames of slow
   * motion: the facts are about the motion itself. An update that throws is passed over.
   */
  async function prepare() {
    const empty = await drawing(browser.createX3DFromString(EMPTY));
    const collection = Object.getPrototypeOf(empty.getNamedNode('c').getValue());
    const { getTimeStep } = collection;
    collection.getTimeStep = function () {
      if (loading) throw new Error('still loading');
      this.deltaTime ||= FRAME / 1000;
      return getTimeStep.call(this);
    };
  }

  let prepared;

  /** A value of X_ITE's as plain data: nodes by name, Contacts with all their fields. */
  function plain(value) {
    if (value === null || typeof value !== 'object') return value ?? null;
    if (typeof value.getNodeTypeName === 'function') return plainNode(value);
    if (typeof value.length === 'number' && !('x' in value)) return Array.from(value, plain);
    if ('angle' in value) return [value.x, value.y, value.z, value.angle];
    return ['x', 'y', 'z'].filter((name) => name in value).map((name) => value[name]);
  }

  function plainNode(node) {
    if (node.getNodeTypeName() !== 'Contact') return node.getNodeName() || null;
    const names = Array.from(node.getFieldDefinitions(), ({ name }) => name);
    return Object.fromEntries(names.map((name) => [name, plain(node[name])]));
  }

  function typeOf(node, field) {
    const definition = Array.from(node.getFieldDefinitions()).find(({ name }) => name === field);
    if (!definition) throw new Error(`${node.getNodeTypeName()} has no field ${field}`);
    return node.getField(field).getTypeName();
  }

  /** Plain data as a value of X_ITE's. */
  function field(type, value) {
    const { X3D } = page;
    if (type === 'SFNode') return value === null ? null : made(value);
    if (type === 'MFNode') return new X3D.MFNode(...value.map(made));
    if (type.startsWith('MF')) {
      const one = type.replace('MF', 'SF');
      return new X3D[type](...value.map((item) => field(one, item)));
    }
    return Array.isArray(value) ? new X3D[type](...value) : value;
  }

  function made(data) {
    if (data.USE) return scene.getNamedNode(data.USE);
    const { type, DEF, ...fields } = data;
    const node = scene.createNode(type);
    for (const [name, value] of Object.entries(fields)) assign(node, name, value);
    if (DEF) scene.addNamedNode(DEF, node);
    return node;
  }

  function assign(node, name, value) {
    const type = typeOf(node, name);
    const list = type === 'MFNode' && !Array.isArray(value) ? [value] : value;
    node[name] = field(type, list);
  }

  page.addEventListener(
    'load',
    () => (browser = page.document.querySelector('x3d-canvas').browser),
  );

  page.conformance = {
    version() {
      return browser.version;
    },

    async show(text) {
      loading = true;
      await (prepared ??= prepare());
      scene = await drawing(browser.createX3DFromString(text));
      await drawing(browser.replaceWorld(scene));
      loading = false;
    },

    get(def, name) {
      const node = scene.getNamedNode(def);
      typeOf(node, name);
      return plain(node[name]);
    },

    set(def, name, value) {
      assign(scene.getNamedNode(def), name, value);
    },

    advance(frames) {
      for (let i = 0; i < frames; i++) {
        browser.addBrowserEvent();
        drawFrame();
      }
    },
  };
})();
