import { expect } from 'chai';
import { worldOf, type World } from '../../inside.js';
import { codes, drawn, place, show, until } from '../../scene.js';

/** What is read off a system's element, and what x3dom has of it. */
interface System extends Element {
  positions: number[][];
  count: number;
  isActive: boolean;
  createParticles: boolean;
  emitter: Element | null;
  getFieldValue(name: string): unknown;
}

interface Mesh {
  _positions: Float32Array[];
  _indices: ArrayLike<number>[];
  _normals: ArrayLike<number>[];
  _colors: Float32Array[];
  _texCoords: Float32Array[];
  _primType: string;
}

interface Drawn {
  _cf: { geometry: { node: { _mesh: Mesh } }; appearance: { node: object } };
}

/** The Shapes that stand in no document. */
function clouds(x3d: Element): Drawn[] {
  const { canvas } = (x3d as unknown as { runtime: { canvas: { doc: { _scene: any } } } }).runtime;
  return canvas.doc._scene._childNodes.filter(
    (node: any) => node._cf.geometry && node._xmlNode === null,
  );
}

const meshOf = (x3d: Element): Mesh => clouds(x3d)[0]!._cf.geometry.node._mesh;

const BODY =
  '<x3d-rigid-body-collection id="c" rest="never" gravity="0 0 0"><x3d-rigid-body id="b" position="50 0 0"></x3d-rigid-body></x3d-rigid-body-collection>';

/** Straight upwards, one a tenth of a second, each for a second. */
const UP = 'direction="0 1 0" speed="1" variation="0" mass="1"';
const FIELDS =
  'maxparticles="10" particlelifetime="1" lifetimevariation="0" particlesize="0.2 0.4"';

const system = (inside: string, fields = ''): string =>
  `<x3d-particle-system id="s" ${FIELDS} ${fields}>${inside}</x3d-particle-system>`;
const EMITTER = `<x3d-point-emitter id="e" ${UP}></x3d-point-emitter>`;

/** The scene, its world paused at `seconds`. */
async function after(
  seconds: number,
  content: string,
  bodies = BODY,
): Promise<{ x3d: Element; world: World; s: System }> {
  const { x3d, world } = await show(bodies + content, '#c');
  world.paused = true;
  world.reset();
  world.advance(seconds);
  await drawn();
  return { x3d, world, s: x3d.querySelector('#s') as System };
}

const near = (actual: number[], expected: number[], off = 1e-9): void => {
  expect(actual.length).to.equal(expected.length);
  actual.forEach((value, i) => expect(value).to.be.closeTo(expected[i]!, off));
};

describe('particle systems in a page', () => {
  it('custom tags and plain ones bear the same particles', async () => {
    const plain = `<particlesystem id="s" ${FIELDS}><pointemitter ${UP}></pointemitter></particlesystem>`;
    const custom = await after(0.55, system(EMITTER));
    const byTags = custom.s.positions;
    expect(byTags.length).to.equal(6);
    near(byTags[0]!, [0, 0.55, 0]);
    expect(custom.world.problems).to.eql([]);
    const { s, world } = await after(0.55, plain);
    expect(world.node(s)!.get('positions')).to.eql(byTags);
    expect(s.getFieldValue('count')).to.equal(6);
    expect(world.problems).to.eql([]);
  });

  it('one that comes into a running scene joins it, with what was set before its tag was known', async () => {
    const { x3d, world } = await show(BODY, '#c');
    const s = document.createElement('x3d-particle-system') as unknown as System;
    s.createParticles = false;
    s.innerHTML = EMITTER;
    x3d.querySelector('scene')!.append(s);
    await until(() => world.node(s) !== undefined);
    expect(s.createParticles).to.be.false;
    world.paused = true;
    world.advance(0.5);
    expect(s.count).to.equal(0);
    s.createParticles = true;
    world.advance(0.5);
    expect(s.count).to.be.above(3);
    expect(s.isActive).to.be.true;
    s.remove();
    await until(() => world.node(s) === undefined);
    await drawn();
    expect(clouds(x3d)).to.eql([]);
    expect(world.problems).to.eql([]);
  });

  it('without any body it has the world of its <x3d>', async () => {
    const x3d = place(system(EMITTER));
    const s = x3d.querySelector('#s') as System;
    await until(() => worldOf(s) !== undefined);
    const world = worldOf(s)!;
    await world.ready;
    await until(() => s.count > 2);
    expect(world.problems).to.eql([]);
  });

  it('its wind pushes bodies, in the frame of the Transforms above it and without an emitter', async () => {
    const wind =
      '<x3d-wind-physics-model direction="0 1 0" speed="5" gustiness="0"></x3d-wind-physics-model>';
    const ball = `<transform id="t"><shape><sphere radius="0.5"></sphere></shape></transform>
      <x3d-rigid-body-collection id="c" rest="never" gravity="0 0 0">
        <x3d-rigid-body id="b" mass="2"><x3d-collidable-shape for="t"></x3d-collidable-shape></x3d-rigid-body>
      </x3d-rigid-body-collection>`;
    const { x3d, world, s } = await after(
      0.5,
      `<transform rotation="0 0 1 -1.5707963267948966" scale="2 2 2">${system(wind, 'pushes="true"')}</transform>`,
      ball,
    );
    // 5 m/s along x: no scale changes how strong a wind is.
    const k = (0.64615 * Math.PI * 0.25) / 2;
    const body = world.node(x3d.querySelector('#b')!)!;
    const speed = 5 - 5 / (1 + k * 5 * world.time);
    near(body.get('linearVelocity') as number[], [speed, 0, 0], 1e-5);
    expect(s.count).to.equal(0);
    expect(world.problems).to.eql([]);
  });

  it('emits in the frame of the Transforms above it, and follows their edits', async () => {
    const { world, s } = await after(
      0.25,
      `<transform id="t" translation="3 0 0" rotation="0 0 1 -1.5707963267948966" scale="2 2 2">${system(EMITTER)}</transform>`,
    );
    // What goes up there goes along x, twice as fast.
    near(s.positions[0]!, [3.5, 0, 0], 1e-6);
    expect(world.node(s)!.get('particleSize')).to.eql([0.4, 0.8]);
    document.getElementById('t')!.setAttribute('translation', '0 0 7');
    world.advance(0.1);
    near(s.positions[0]!, [3.7, 0, 0], 1e-6);
    const last = s.positions.at(-1)!;
    expect(last[2]).to.be.closeTo(7, 1e-6);
    expect(last[0]).to.be.within(0, 0.2);
  });

  it('is carried by the body that moves a Transform above it', async () => {
    const { s } = await after(
      0,
      `<transform translation="0 2 0"><shape><box></box></shape><x3d-rigid-body id="car" linearVelocity="0 0 3"></x3d-rigid-body>${system(EMITTER)}</transform>`,
    );
    const world = worldOf(s)!;
    expect(world).to.equal(worldOf(document.getElementById('car')!));
    world.paused = true;
    world.settings.set('gravity', [0, 0, 0]);
    world.reset();
    world.advance(0.55);
    // The first was born at once, and goes along with the body.
    near(s.positions[0]!, [0, 2.55, 1.65], 1e-6);
    expect(world.problems).to.eql([]);
  });

  it('carried, its forces are those of the world, whatever way its emitter is turned', async () => {
    const { s } = await after(
      0,
      `<transform><shape><box></box></shape><x3d-rigid-body id="car" angularVelocity="0 1 0" linearVelocity="0 0 0"></x3d-rigid-body>
         <transform rotation="0 0 1 -1.5707963267948966">${system(`${EMITTER}<x3d-force-physics-model force="0 -4 0"></x3d-force-physics-model>`)}</transform></transform>`,
    );
    const world = worldOf(s)!;
    world.paused = true;
    world.settings.set('gravity', [0, 0, 0]);
    world.reset();
    world.advance(0.5);
    // Thrown along x, with gravity along y.
    near(s.positions[0]!, [0.5, -0.5, 0], 1e-6);
  });

  it('stands on the body of its field, and lives where that does', async () => {
    const { world, s } = await after(
      0.5,
      `<x3d-rigid-body-collection id="other" gravity="0 0 0" rest="never"><x3d-rigid-body id="car" def="CAR" position="0 5 0"></x3d-rigid-body></x3d-rigid-body-collection>
       ${system(`${EMITTER}<x3d-rigid-body use="CAR" containerfield="body"></x3d-rigid-body>`)}`,
    );
    const other = worldOf(document.getElementById('car')!)!;
    expect(worldOf(s)).to.equal(other);
    expect(world).not.to.equal(other);
    other.paused = true;
    other.reset();
    other.advance(0.5);
    near(s.positions[0]!, [0, 5.5, 0]);
  });

  it('takes an emitter and models by USE, from its collection, too', async () => {
    const { world, s } = await after(
      0.5,
      `<x3d-point-emitter def="E" ${UP}></x3d-point-emitter>
       ${system('<x3d-point-emitter use="E"></x3d-point-emitter><x3d-force-physics-model force="0 0 4"></x3d-force-physics-model>')}`,
    );
    near(s.positions[0]!, [0, 0.5, 0.5]);
    expect(codes(world)).to.eql([]);
  });

  it('reads points and geometry of emitters and models where the document has them', async () => {
    const { world, s } = await after(
      0.2,
      system(
        `<x3d-polyline-emitter id="e" ${UP}><coordinate def="C" point="1 0 0 1 0 2"></coordinate></x3d-polyline-emitter>`,
      ),
    );
    for (const [x, , z] of s.positions) {
      expect(x).to.be.closeTo(1, 1e-9);
      expect(z).to.be.within(0, 2);
    }
    s.querySelector('coordinate')!.setAttribute('point', '-1 0 0 -1 0 2');
    world.reset();
    world.advance(0.2);
    for (const [x] of s.positions) expect(x).to.be.closeTo(-1, 1e-9);
    s.querySelector('#e')!.outerHTML =
      `<x3d-surface-emitter speed="0" variation="0"><sphere radius="3"></sphere></x3d-surface-emitter>`;
    await drawn();
    world.reset();
    world.advance(0.2);
    expect(s.count).to.be.above(0);
    for (const place of s.positions) expect(Math.hypot(...place)).to.be.closeTo(3, 0.05);
    expect(codes(world)).to.eql([]);
  });

  it('walls throw back: BoundedPhysicsModel takes the geometry in it', async () => {
    const { s } = await after(
      0.9,
      system(
        `${EMITTER}<x3d-bounded-physics-model><box size="1 1 1"></box></x3d-bounded-physics-model>`,
      ),
    );
    for (const [, y] of s.positions) expect(y).to.be.below(0.5);
  });

  it('edits, ROUTEs and reset act as on any node', async () => {
    const { world, s } = await after(
      0.5,
      `${system(EMITTER)}<timesensor def="T"></timesensor><x3d-particle-system def="S2" id="s2" ${FIELDS}>${EMITTER}</x3d-particle-system>
       <route fromnode="S2" fromfield="isActive" tonode="S3" tofield="set_enabled"></route>
       <x3d-particle-system def="S3" id="s3" enabled="false" ${FIELDS}>${EMITTER}</x3d-particle-system>`,
    );
    world.advance(0.5);
    expect((document.getElementById('s3') as unknown as System).count).to.be.above(0);
    document.getElementById('e')!.setAttribute('on', 'false');
    world.advance(2);
    expect(s.count).to.equal(0);
    expect(s.isActive).to.be.false;
    document.getElementById('e')!.removeAttribute('on');
    s.setAttribute('maxparticles', '1000');
    world.advance(1);
    expect(s.count).to.be.within(900, 1000);
    world.reset();
    expect(s.count).to.equal(0);
  });
});

describe('what particles are drawn as', () => {
  const FORMS: [type: string, primitive: string, corners: number, index: number][] = [
    ['QUAD', 'TRIANGLES', 4, 6],
    ['SPRITE', 'TRIANGLES', 4, 6],
    ['TRIANGLE', 'TRIANGLES', 6, 6],
    ['LINE', 'LINES', 2, 2],
    ['POINT', 'POINTS', 1, 1],
  ];
  for (const [type, primitive, corners, index] of FORMS) {
    it(`${type}: one Shape for all of them, each about where it is`, async () => {
      const { x3d, s } = await after(0.55, system(EMITTER, `geometrytype="${type}"`));
      expect(clouds(x3d).length).to.equal(1);
      const mesh = meshOf(x3d);
      expect(mesh._primType).to.equal(primitive);
      expect(mesh._indices[0]!.length % index).to.equal(0);
      const at = s.positions;
      for (let k = 0; k < at.length; k++) {
        const points = Array.from(
          mesh._positions[0]!.slice(3 * corners * k, 3 * corners * (k + 1)),
        );
        const middle = [0, 1, 2].map((axis) => {
          const values = points.filter((_, i) => i % 3 === axis);
          return (Math.max(...values) + Math.min(...values)) / 2;
        });
        near(middle, at[k]!, 1e-6);
      }
      // Beyond those that live nothing is seen.
      const rest = mesh._positions[0]!.slice(3 * corners * at.length);
      expect(rest.every((value) => value > 1e29)).to.be.true;
    });
  }

  it('far from the origin of the scene they are drawn where they are', async () => {
    const { x3d, s, world } = await after(
      0.05,
      `<transform translation="200000 0 0">${system(EMITTER, 'geometrytype="POINT"')}</transform>`,
      BODY.replace('50 0 0', '200000 0 0'),
    );
    // Bullet counts from there.
    expect((world as unknown as { poses: { origin: number[] } }).poses.origin[0]).to.equal(200000);
    near(s.positions[0]!, [200000, 0.05, 0], 1e-6);
    // Single precision has steps of 16 mm there.
    near(Array.from(meshOf(x3d)._positions[0]!.slice(0, 3)), s.positions[0]!, 0.016);
  });

  it('QUAD lies in the plane of its frame, as wide and high as particleSize says', async () => {
    const { x3d } = await after(
      0.05,
      `<transform rotation="1 0 0 -1.5707963267948966">${system(EMITTER)}</transform>`,
    );
    const points = meshOf(x3d)._positions[0]!.slice(0, 12);
    const span = (axis: number): number => {
      const values = Array.from(points).filter((_, i) => i % 3 === axis);
      return Math.max(...values) - Math.min(...values);
    };
    near([span(0), span(1), span(2)], [0.2, 0, 0.4], 1e-6);
  });

  it('LINE lies along the way that the particle goes', async () => {
    const { x3d, s } = await after(0.05, system(EMITTER, 'geometrytype="LINE"'));
    const [x, y, z] = s.positions[0]!;
    const ends = Array.from(meshOf(x3d)._positions[0]!.slice(0, 6));
    near(ends, [x!, y! - 0.2, z!, x!, y! + 0.2, z!], 1e-6);
  });

  it('GEOMETRY: the triangles of its geometry', async () => {
    const { x3d, s } = await after(
      0.15,
      system(`${EMITTER}<box size="0.2 0.2 0.2"></box>`, 'geometrytype="GEOMETRY"'),
    );
    const mesh = meshOf(x3d);
    expect(mesh._indices[0]!.length % 36).to.equal(0);
    const corners = mesh._positions[0]!.slice(0, 72);
    const [x, y, z] = s.positions[0]!;
    const low = [0, 1, 2].map((axis) =>
      Math.min(...Array.from(corners).filter((_, i) => i % 3 === axis)),
    );
    near(low, [x! - 0.1, y! - 0.1, z! - 0.1], 1e-6);
  });

  it('colours run from key to key, and texture coordinates hold until the next', async () => {
    const { x3d, s } = await after(
      0.25,
      system(
        `${EMITTER}<appearance><material></material></appearance>
         <colorrgba containerfield="color" color="1 0 0 1, 0 0 1 0"></colorrgba>
         <texturecoordinate containerfield="texCoord" point="0 0 .5 0 .5 .5 0 .5, .5 .5 1 .5 1 1 .5 1"></texturecoordinate>`,
        'colorkey="0 0.5" texcoordkey="0 0.2"',
      ),
    );
    const mesh = meshOf(x3d);
    // Farthest first where it fades: they are all as far.
    expect(s.count).to.equal(3);
    const alphas = [0, 1, 2].map((k) => mesh._colors[0]![16 * k + 3]!).sort();
    near(alphas, [0.5, 0.7, 0.9], 1e-6);
    const sets = [0, 1, 2].map((k) => mesh._texCoords[0]![8 * k]!).sort();
    expect(sets).to.eql([0, 0, 0.5]);
  });

  it('nothing of it stands in the document', async () => {
    const { x3d } = await after(0.5, system(EMITTER));
    expect(x3d.querySelectorAll('#s *').length).to.equal(1);
    expect(clouds(x3d).length).to.equal(1);
  });

  it('its appearance is that of the document, edits included', async () => {
    const { x3d } = await after(
      0.5,
      system(
        `${EMITTER}<appearance id="a"><material id="m" diffusecolor="1 0 0"></material></appearance>`,
      ),
    );
    // Compared here: what chai would print of a node is all of x3dom.
    const isOf = (id: string): boolean =>
      clouds(x3d)[0]?._cf.appearance.node ===
      (document.getElementById(id) as unknown as { _x3domNode: object })._x3domNode;
    expect(isOf('a')).to.be.true;
    document.getElementById('a')!.outerHTML =
      '<appearance id="a2"><material diffusecolor="0 1 0"></material></appearance>';
    await until(() => isOf('a2'));
  });

  it('edits of how it looks are drawn', async () => {
    const { x3d, s } = await after(0.15, system(`${EMITTER}<box size="1 1 1"></box>`));
    const kind = (): string => meshOf(x3d)._primType;
    s.setAttribute('geometrytype', 'LINE');
    await drawn();
    expect(kind()).to.equal('LINES');
    s.setAttribute('geometrytype', 'GEOMETRY');
    await drawn();
    const width = (): number => {
      const xs = Array.from(meshOf(x3d)._positions[0]!.slice(0, 72)).filter((_, i) => i % 3 === 0);
      return Math.max(...xs) - Math.min(...xs);
    };
    expect(width()).to.be.closeTo(1, 1e-6);
    s.querySelector('box')!.setAttribute('size', '3 1 1');
    await until(() => Math.abs(width() - 3) < 1e-6);
    expect(clouds(x3d).length).to.equal(1);
  });

  it('what a Switch does not choose, or nobody renders, is not seen', async () => {
    const { x3d, s } = await after(
      0.5,
      `<switch id="w" whichchoice="0"><group id="g">${system(EMITTER)}</group></switch>`,
    );
    const seen = (): boolean =>
      (clouds(x3d)[0] as unknown as { renderFlag(): boolean }).renderFlag();
    expect(seen()).to.be.true;
    document.getElementById('w')!.setAttribute('whichchoice', '-1');
    await drawn();
    expect(seen()).to.be.false;
    document.getElementById('w')!.setAttribute('whichchoice', '0');
    await drawn();
    expect(seen()).to.be.true;
    (s as unknown as { visible: boolean }).visible = false;
    await drawn();
    expect(seen()).to.be.false;
    (s as unknown as { visible: boolean }).visible = true;
    await drawn();
    expect(seen()).to.be.true;
    document.getElementById('g')!.setAttribute('render', 'false');
    await drawn();
    expect(seen()).to.be.false;
  });

  it('x3dom knows how far particles are: none is cut off', async () => {
    const { x3d, s } = await after(0.55, system(EMITTER.replace('speed="1"', 'speed="30"')));
    const shape = clouds(x3d)[0] as unknown as { getVolume(): any };
    const { min, max, valid } = shape.getVolume();
    expect(valid).to.be.true;
    for (const [x, y, z] of s.positions) {
      expect(x).to.be.within(min.x, max.x);
      expect(y).to.be.within(min.y, max.y);
      expect(z).to.be.within(min.z, max.z);
    }
  });

  it('an Appearance that others have, too, stays as it is where particles fade', async () => {
    const { x3d, world } = await after(
      0.5,
      system(
        `${EMITTER}<appearance def="A" id="a"><material></material></appearance><colorrgba containerfield="color" color="1 0 0 0"></colorrgba>`,
      ) + '<shape><appearance use="A"></appearance><box></box></shape>',
    );
    const { _x3domNode: node } = document.getElementById('a') as unknown as { _x3domNode: any };
    expect(node._vf.sortType).to.equal('opaque');
    expect((clouds(x3d)[0]!._cf.appearance.node as any)._vf.sortType).to.equal('transparent');
    expect(node._parentNodes.length).to.equal(2);
    expect(world.problems).to.eql([]);
  });

  it('particles that fade hide nothing that is behind them, unless their author says how depth is written', async () => {
    const depth = async (inside: string): Promise<unknown> => {
      const { x3d } = await after(
        0.5,
        system(
          `${EMITTER}<appearance><material></material>${inside}</appearance><colorrgba containerfield="color" color="1 0 0 0"></colorrgba>`,
        ),
      );
      return (clouds(x3d)[0]!._cf.appearance.node as any)._cf.depthMode.node._vf.readOnly;
    };
    expect(await depth('')).to.be.true;
    expect(await depth('<depthmode readonly="false"></depthmode>')).to.be.false;
  });

  it('what stands far away stays in sight, however far particles fly', async () => {
    const { x3d, world } = await after(
      0.1,
      system(EMITTER.replace('speed="1"', 'speed="60"')) +
        '<shape><box size="400 1 400"></box></shape>',
    );
    const { canvas } = (x3d as any).runtime;
    const far: number[] = [];
    for (let frame = 0; frame < 30; frame++) {
      world.advance(0.05);
      await drawn();
      far.push(Math.round(canvas.doc._scene.getViewpoint()._zFar));
    }
    expect(far.filter((distance) => distance < 190)).to.deep.equal([]);
  });

  it('an x3d that is taken out and put back draws them again', async () => {
    const { x3d } = await after(0.5, system(EMITTER));
    const { parentElement } = x3d;
    x3d.remove();
    await drawn();
    parentElement!.append(x3d);
    await until(() => {
      const { canvas } = (x3d as any).runtime ?? {};
      return !!canvas?.doc?._scene && clouds(x3d).length === 1;
    });
  });
});
