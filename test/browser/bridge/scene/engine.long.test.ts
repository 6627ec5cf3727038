import { expect } from 'chai';
import '../../console.js';
import { openText, type PageWindow } from '../../page.js';
import { until } from '../../scene.js';

const FILE = '/dist/ammo.wasm';
const OTHER = '/node_modules/ammojs-typed/ammo/ammo.wasm.wasm';

const MODULE = '<script type="module" src="/dist/x3d-physics.js"></script>';
const CLASSIC = '<script src="/dist/x3d-physics.classic.js"></script>';
const module = (text: string): string => `<script type="module">
  import { configure } from '/dist/x3d-physics.js';
  ${text}
</script>`;

/** Counts what is compiled while it comes, and lets the server answer `FILE` with `status`, `type` and `body`. */
const answering = (response: string): string => `<script>
  var fetched = [], streamed = 0, compile = WebAssembly.compileStreaming, get = window.fetch;
  WebAssembly.compileStreaming = function (response) { streamed++; return compile.call(WebAssembly, response); };
  window.fetch = async function (url) {
    var path = new URL(url, document.baseURI).pathname;
    fetched.push(path);
    if (path !== '${FILE}') return get(url);
    var answer = await get('${OTHER}');
    return ${response};
  };
</script>`;
const AS_IT_IS = answering('answer');
const WITHOUT_TYPE = answering("new Response(answer.body, { headers: { 'content-type': '' } })");
const NOT_FOUND = answering("new Response('Not found', { status: 404 })");
const PAGE_INSTEAD = answering(
  "new Response('<!doctype html>', { headers: { 'content-type': 'text/html' } })",
);
const PAGE_AS_WASM = answering(
  "new Response('<!doctype html>', { headers: { 'content-type': 'application/wasm' } })",
);
const OFFLINE = answering("Promise.reject(new Error('no network'))");

interface World {
  ready: Promise<World>;
  problems: { code: string; message: string }[];
}

interface Seen extends PageWindow {
  fetched: string[];
  streamed: number;
}

async function show(...scripts: string[]) {
  const page = (await openText(`<!DOCTYPE html>
    <script src="/node_modules/x3dom/x3dom.js"></script>
    <x3d width="200px" height="100px"><scene>
      <transform><shape><box></box></shape><x3d-rigid-body></x3d-rigid-body></transform>
    </scene></x3d>${scripts.join('')}`)) as Seen;
  const body = page.document.querySelector('x3d-rigid-body') as Element & { world?: World };
  await until(() => body.world !== undefined);
  return { page, world: body.world!, started: body.world!.ready };
}

/** The chunk with the wasm as text was loaded. */
const spareCame = (page: Window): boolean =>
  page.performance.getEntriesByType('resource').some(({ name }) => name.includes('wasm-as-text'));

describe('the wasm of a page', () => {
  it('is compiled while it comes, and its spare is not loaded', async () => {
    const { page, started } = await show(AS_IT_IS, MODULE);
    await started;
    expect(page.fetched).to.eql([FILE]);
    expect(page.streamed).to.equal(1);
    expect(spareCame(page)).to.equal(false);
  });

  it('needs no type from the server', async () => {
    const { page, started } = await show(WITHOUT_TYPE, MODULE);
    await started;
    expect(page.streamed).to.equal(0);
    expect(spareCame(page)).to.equal(false);
  });

  for (const [what, server] of Object.entries({
    'answers 404': NOT_FOUND,
    'answers a page in its place': PAGE_INSTEAD,
    'calls a page WebAssembly': PAGE_AS_WASM,
    'can not be reached': OFFLINE,
  })) {
    it(`comes as text where the server ${what}`, async () => {
      const { page, started } = await show(server, MODULE);
      await started;
      expect(page.fetched).to.eql([FILE]);
      expect(spareCame(page)).to.equal(true);
    });
  }

  it('comes from where the page says: a module', async () => {
    const { page, started } = await show(AS_IT_IS, module(`configure({ wasmUrl: '${OTHER}' });`));
    await started;
    expect(page.fetched).to.eql([OTHER]);
    expect(spareCame(page)).to.equal(false);
  });

  it('comes from where the page says: a classic script', async () => {
    const { page, started } = await show(
      AS_IT_IS,
      CLASSIC,
      `<script>X3DPhysics.configure({ wasmUrl: '${OTHER}' });</script>`,
    );
    await started;
    expect(page.fetched.at(-1)).to.equal(OTHER);
  });

  it('comes from where the page says: the script with the wasm inside', async () => {
    const { page, started } = await show(
      AS_IT_IS,
      '<script src="/dist/x3d-physics.single.js"></script>',
      `<script>X3DPhysics.configure({ wasmUrl: '${OTHER}' });</script>`,
    );
    await started;
    expect(page.fetched).to.eql([OTHER]);
  });

  it('that is not where the page says is a problem that names the address, and the way', async () => {
    const { page, world, started } = await show(
      AS_IT_IS,
      module("configure({ wasmUrl: '/test/no-such.wasm' });"),
    );
    const problem = await started.then(
      () => undefined,
      (reason: { code: string; message: string }) => reason,
    );
    expect(problem!.code).to.equal('engine-load-failed');
    expect(problem!.message).to.contain('/test/no-such.wasm').and.contain('configure({ wasmUrl })');
    expect(world.problems.map(({ code }) => code)).to.eql(['engine-load-failed']);
    expect(spareCame(page)).to.equal(false);
  });

  it('can not be moved once it is loaded', async () => {
    const { page, started } = await show(CLASSIC);
    await started;
    const { configure } = page.X3DPhysics as unknown as { configure(source: object): void };
    expect(() => configure({ wasmUrl: OTHER })).to.throw('too late');
  });
});
