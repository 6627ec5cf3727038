import { expect } from 'chai';
import { claim } from '../../console.js';
import { drawn, until, wait } from '../../scene.js';
import {
  bodies,
  colored,
  difference,
  documentOf,
  draws,
  drawPlainly,
  errorOf,
  picture,
  showBatched,
  wrapped,
} from './pictures.js';
import { COUNT, boxes, type Shown, find } from './members.js';

const field = (element: Element, name: string, value: unknown): void =>
  (element as unknown as { setFieldValue(name: string, value: unknown): void }).setFieldValue(
    name,
    value,
  );

const rgb = (...values: number[]): unknown => {
  type Fields = { x3dom: { fields: { SFColor: new (...values: number[]) => unknown } } };
  return new (globalThis as unknown as Fields).x3dom.fields.SFColor(...values);
};

/** What is done to one of them, and how many draws it then takes. */
const EDITS: [string, number, (shown: Shown) => unknown][] = [
  [
    'another colour',
    1,
    (shown) => find(shown, '#s3 material').setAttribute('diffuseColor', '1 0 0'),
  ],
  [
    'another colour, by its field',
    1,
    (shown) => field(find(shown, '#s3 material'), 'diffuseColor', rgb(1, 0, 0)),
  ],
  [
    'a highlight',
    1,
    (shown) => {
      const shape = find(shown, '#s3') as Element & {
        highlight(on: boolean, color: unknown): void;
      };
      shape.highlight(true, rgb(1, 1, 0));
    },
  ],
  ['another size', 1, (shown) => find(shown, '#s3 box').setAttribute('size', '0.4 1.4 0.4')],
  [
    'another geometry',
    2,
    (shown) => {
      find(shown, '#s3 box').remove();
      find(shown, '#s3').insertAdjacentHTML('beforeend', '<sphere radius="0.6"></sphere>');
    },
  ],
  [
    'another Appearance',
    2,
    (shown) => {
      find(shown, '#s3 appearance').remove();
      find(shown, '#s3').insertAdjacentHTML('beforeend', colored(3, 'emissivecolor="0 0.5 0"'));
    },
  ],
  ['a shine', 2, (shown) => find(shown, '#s3 material').setAttribute('specularColor', '1 1 1')],
  ['transparency', 2, (shown) => find(shown, '#s3 material').setAttribute('transparency', '0.5')],
  ['no `solid`', 2, (shown) => find(shown, '#s3 box').setAttribute('solid', 'false')],
  ['`render` of the Transform', 1, (shown) => find(shown, '#t3').setAttribute('render', 'false')],
  ['`render` of the Shape', 1, (shown) => find(shown, '#s3').setAttribute('render', 'false')],
  ['`visible` of the Transform', 1, (shown) => find(shown, '#t3').setAttribute('visible', 'false')],
  ['its bounding box shown', 3, (shown) => find(shown, '#t3').setAttribute('bboxDisplay', 'true')],
  ['another place', 1, (shown) => find(shown, '#t3').setAttribute('translation', '0 3 0')],
  ['a scale', 1, (shown) => find(shown, '#t3').setAttribute('scale', '0.3 2 0.3')],
  [
    'a second Shape',
    3,
    (shown) =>
      find(shown, '#t3').insertAdjacentHTML(
        'beforeend',
        '<shape><sphere radius="0.7"></sphere></shape>',
      ),
  ],
  ['its body gone', 1, (shown) => find(shown, '#b3').remove()],
  ['its Transform gone', 1, (shown) => find(shown, '#t3').remove()],
  [
    'a place in another group, where others are drawn',
    3,
    async (shown) => {
      find(shown, 'scene').insertAdjacentHTML(
        'beforeend',
        '<transform id="g" translation="0 1 0"><shape><sphere radius="0.2"></sphere></shape></transform>',
      );
      await drawn();
      find(shown, '#g').append(find(shown, '#t3'));
    },
  ],
  [
    'a place in a group of its own',
    1,
    async (shown) => {
      find(shown, 'scene').insertAdjacentHTML(
        'beforeend',
        '<transform id="g" translation="0 1 0"></transform>',
      );
      await drawn();
      find(shown, '#g').append(find(shown, '#t3'));
    },
  ],
  ['batch="false"', 2, (shown) => find(shown, '#b3').setAttribute('batch', 'false')],
  ['batch="false" at its Shape', 2, (shown) => find(shown, '#s3').setAttribute('batch', 'false')],
  [
    'another of its kind beside it',
    1,
    (shown) =>
      find(shown, 'scene').insertAdjacentHTML(
        'beforeend',
        `<transform translation="0 3.2 0"><shape>${colored(3)}<box size="1 1 1"></box></shape><x3d-rigid-body></x3d-rigid-body></transform>`,
      ),
  ],
];

describe('a body drawn with others that is given', () => {
  for (const [what, after, edit] of EDITS)
    it(`${what} looks as it does drawn by itself`, async () => {
      const shown = await showBatched(boxes, 1);
      const { x3d, collection } = shown;
      const before = picture(x3d);
      await edit(shown);
      await drawn();
      const together = picture(x3d);
      expect(draws(x3d)).to.equal(after);
      if (!/^(batch|its body|a place|no `solid`)/.test(what))
        expect(difference(before, together).any).to.be.above(0);
      await drawPlainly(collection, true);
      expect(draws(x3d)).to.be.at.least(COUNT - 1);
      expect(difference(together, picture(x3d)).any).to.equal(0);
      expect(errorOf(x3d)).to.equal(0);
    });

  it('back what it had is drawn with them again', async () => {
    const shown = await showBatched(boxes, 1);
    const { x3d } = shown;
    const before = picture(x3d);
    const material = find(shown, '#s3 material');
    material.setAttribute('transparency', '0.5');
    await drawn();
    expect(draws(x3d)).to.equal(2);
    material.setAttribute('transparency', '0');
    await drawn();
    expect(draws(x3d)).to.equal(1);
    expect(difference(before, picture(x3d)).any).to.equal(0);
  });
});

/** The same of a body in groups of its own. */
const EDITS_OF_GROUPS: [string, number, (shown: Shown) => unknown][] = [
  ['another colour', 1, EDITS[0]![2]],
  ['another size', 1, (shown) => find(shown, '#s3 box').setAttribute('size', '0.4 1.4 0.4')],
  ['another place', 1, (shown) => find(shown, '#t3').setAttribute('translation', '0 3 0')],
  [
    'another place of a Transform round it',
    1,
    (shown) => find(shown, '#o3').setAttribute('scale', '0.3 1 1'),
  ],
  [
    'another place of a Transform in it',
    1,
    (shown) => find(shown, '#i3').setAttribute('translation', '0 1 0'),
  ],
  [
    '`render` of a group round it',
    1,
    (shown) => find(shown, '#g3').setAttribute('render', 'false'),
  ],
  ['`render` of a group in it', 1, (shown) => find(shown, '#h3').setAttribute('render', 'false')],
  [
    'a bounding box shown round it',
    3,
    (shown) => find(shown, '#g3').setAttribute('bboxDisplay', 'true'),
  ],
  [
    'a Shape beside it in its group',
    3,
    (shown) =>
      find(shown, '#g3').insertAdjacentHTML(
        'beforeend',
        '<shape><sphere radius="0.7"></sphere></shape>',
      ),
  ],
  [
    'a second Shape',
    3,
    (shown) =>
      find(shown, '#h3').insertAdjacentHTML(
        'beforeend',
        '<shape><sphere radius="0.7"></sphere></shape>',
      ),
  ],
  ['its group gone', 1, (shown) => find(shown, '#g3').remove()],
  ['its Transform gone', 1, (shown) => find(shown, '#t3').remove()],
];

describe('a body in groups of its own, drawn with others, that is given', () => {
  for (const [what, after, edit] of EDITS_OF_GROUPS)
    it(`${what} looks as it does drawn by itself`, async () => {
      const shown = await showBatched(wrapped(boxes), 1);
      const { x3d, collection } = shown;
      const before = picture(x3d);
      await edit(shown);
      await drawn();
      const together = picture(x3d);
      expect(draws(x3d)).to.equal(after);
      expect(difference(before, together).any).to.be.above(0);
      await drawPlainly(collection, true);
      expect(draws(x3d)).to.be.at.least(COUNT - 1);
      expect(difference(together, picture(x3d)).any).to.equal(0);
      expect(errorOf(x3d)).to.equal(0);
    });

  for (const [what, where, body] of [
    ['a body of its own in its group', '#i3', '<x3d-rigid-body></x3d-rigid-body>'],
    [
      'a body elsewhere that moves its group',
      'scene',
      '<x3d-rigid-body><x3d-collidable-shape for="i3"></x3d-collidable-shape></x3d-rigid-body>',
    ],
  ] as const)
    it(`${what} is drawn by itself`, async () => {
      const shown = await showBatched(wrapped(boxes), 1);
      const { x3d } = shown;
      find(shown, where).insertAdjacentHTML('beforeend', body);
      await drawn();
      claim('[waiting-for-geometry]');
      expect(draws(x3d)).to.equal(2);
    });
});

describe('bodies drawn in one call', () => {
  for (const [where, all] of [
    ['', boxes],
    [', in groups of their own', wrapped(boxes.replaceAll('1 1 1', '0.6 0.6 0.6'))],
  ] as const)
    it(`are within the bounds that x3dom gives of each, of their group and of the scene${where}`, async () => {
      const { x3d, world, collection } = await showBatched(`<group id="all">${all}</group>`, 1);
      collection.setAttribute('enabled', 'true');
      world.paused = true;
      world.advance(0.3);
      await drawn();
      const { runtime } = x3d as unknown as {
        runtime: { getBBox(element: Element): unknown; getSceneBBox(): unknown };
      };
      const boundsOf = () => [
        ...['#t3', '#s3', '#t11', '#all', ...(where ? ['#g3', '#o3', '#h3', '#i3'] : [])].map(
          (name) => runtime.getBBox(x3d.querySelector(name)!),
        ),
        runtime.getSceneBBox(),
      ];
      picture(x3d);
      const together = JSON.stringify(boundsOf());
      await drawPlainly(collection, true);
      picture(x3d);
      expect(together).to.equal(JSON.stringify(boundsOf()));
    });

  it('come and go a thousand times without a trace in WebGL', async () => {
    const shown = await showBatched(boxes, 1);
    const { x3d } = shown;
    const gl = (
      x3d as unknown as { runtime: { canvas: { doc: { ctx: { ctx3d: WebGL2RenderingContext } } } } }
    ).runtime.canvas.doc.ctx.ctx3d;
    let made = 0;
    const { createBuffer, deleteBuffer } = gl;
    gl.createBuffer = () => (made++, createBuffer.call(gl));
    gl.deleteBuffer = (buffer) => {
      if (buffer) made--;
      deleteBuffer.call(gl, buffer);
    };
    const scene = find(shown, 'scene');
    const round = async (rounds: number): Promise<void> => {
      for (let i = 0; i < rounds; i++) {
        const color = `${i % 2} ${i % 3} 0.5`;
        scene.insertAdjacentHTML(
          'beforeend',
          bodies(
            20,
            () =>
              `<appearance><material diffusecolor="${color}"></material></appearance><box size="1 1 1"></box>`,
          )
            .replaceAll(/ id="\w+"/g, '')
            .replaceAll('<transform', '<transform class="more"'),
        );
        await wait(0);
        picture(x3d);
        for (const more of scene.querySelectorAll('.more')) more.remove();
        await wait(0);
        picture(x3d);
      }
    };
    await round(2);
    const before = made;
    await round(50);
    expect(made).to.equal(before);
    expect([draws(x3d), errorOf(x3d)]).to.eql([1, 0]);
  });
});

describe('a Transform of a batch', () => {
  it('is asked nothing in frames of x3dom until somebody listens to where it is', async () => {
    const shown = await showBatched(boxes, 1);
    const asked = (): unknown[] => documentOf(shown.x3d)._nodeBag.trans;
    await until(() => asked().length < COUNT);
    let heard = 0;
    const transform = find(shown, '#t3');
    transform.addEventListener('transform', () => heard++);
    await until(() => heard > 2);
    expect(asked()).to.include((transform as Element & { _x3domNode: unknown })._x3domNode);
    find(shown, '#t4').setAttribute('ontransform', 'this.dataset.heard = "yes"');
    await until(() => find(shown, '#t4').getAttribute('data-heard') === 'yes');
    expect(draws(shown.x3d)).to.equal(1);
  });

  it('is asked again when it is drawn by itself', async () => {
    const shown = await showBatched(boxes, 1);
    const asked = (): unknown[] => documentOf(shown.x3d)._nodeBag.trans;
    await until(() => asked().length < COUNT);
    await drawPlainly(shown.collection, true);
    expect(asked().length).to.be.above(COUNT);
    for (const transform of shown.x3d.querySelectorAll('transform')) transform.remove();
    await drawn();
    expect(asked().length).to.be.below(COUNT);
  });
});

describe('bodies that are seen through', () => {
  it('are left to x3dom, alike as they may be: it draws them from the back to the front', async () => {
    const glass = bodies(
      COUNT,
      (i) => `${colored(i, 'transparency="0.5"')}<box size="1 1 1"></box>`,
    );
    const { x3d, world } = await showBatched(glass, COUNT);
    await until(() => world.stats.batches === 0);
    await drawn();
    expect(draws(x3d)).to.equal(COUNT);
  });
});
