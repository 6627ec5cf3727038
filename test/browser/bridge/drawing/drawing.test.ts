import { expect } from 'chai';
import { drawn, drawnAt, show, until, wait } from '../../scene.js';
import { worldOf } from '../../inside.js';

interface Node {
  _trafo: Record<string, number>;
  _vf: { translation: { y: number } };
  fieldChanged(name: string): void;
}
const nodeOf = (element: Element): Node => (element as unknown as { _x3domNode: Node })._x3domNode;

describe('what is drawn', () => {
  it("keeps the Transform's own fields true, its centre and scale included", async () => {
    const { x3d, world } = await show(
      `
      <transform scale="2 1 1" rotation="0 1 0 1"><transform id="t" translation="0 5 0" center="0.3 0.2 0" scale="1 2 3" rotation="1 0 0 1">
        <shape><box></box></shape><x3d-rigid-body id="b" angularvelocity="1 2 3"></x3d-rigid-body></transform></transform>
      <transform id="u" translation="20 5 0" center="0.3 0.2 0" scale="1 2 3" rotation="1 0 0 1">
        <shape><box></box></shape><x3d-rigid-body id="v" angularvelocity="1 2 3"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.paused = true;
    world.advance(0.5);
    await drawn();
    const node = nodeOf(x3d.querySelector('#u')!);
    const before = { ...node._trafo };
    node.fieldChanged('translation');
    for (const key of Object.keys(before))
      expect(node._trafo[key]).to.be.closeTo(before[key], 1e-4);
    expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.below(4.9);
  });

  it('nothing is written and no frame asked for at rest', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t"><shape><box size="9 1 9"></box></shape><x3d-rigid-body fixed="true"></x3d-rigid-body></transform>
      <transform translation="0 1 0"><shape><box size="1 1 1"></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.advance(6);
    await until(() => world.stats.awake === 0 && !world.stepping.needsFrame);
    await drawn();
    await wait(100);
    const doc = (x3d as unknown as { runtime: { canvas: { doc: { needRender: unknown } } } })
      .runtime.canvas.doc;
    doc.needRender = false;
    await wait(200);
    expect(world.stepping.needsFrame).to.equal(false);
    expect(doc.needRender).to.be.oneOf([false, 0]);
  });

  it('a body nested in a driven Transform stays where it is in the world', async () => {
    const { x3d, world } = await show(
      `
      <transform id="outer" translation="0 5 0"><shape><box></box></shape><x3d-rigid-body id="a"></x3d-rigid-body>
        <transform id="inner" translation="4 0 0"><shape><sphere></sphere></shape><x3d-rigid-body id="b" useglobalgravity="false"></x3d-rigid-body></transform>
      </transform>`,
      '#a',
    );
    world.paused = true;
    world.reset();
    world.advance(1);
    await drawn();
    expect(drawnAt(x3d.querySelector('#outer')!)[1]).to.be.below(1);
    expect(drawnAt(x3d.querySelector('#inner')!)).to.eql([4, 5, 0]);
  });

  it('an edit of an ancestor carries bodies along, fixed ones too', async () => {
    const { x3d, world } = await show(
      `
      <transform id="up"><transform translation="1 0 0"><shape><box></box></shape><x3d-rigid-body id="f" fixed="true"></x3d-rigid-body></transform>
      <transform translation="3 0 0"><shape><box></box></shape><x3d-rigid-body id="d"></x3d-rigid-body></transform></transform>`,
      '#f',
    );
    world.paused = true;
    await drawn();
    x3d.querySelector('#up')!.setAttribute('translation', '0 7 0');
    const at = (id: string): number[] => world.node(id)!.get('position') as number[];
    await wait(20);
    await until(() => at('f')[1] === 7);
    expect(at('f')).to.eql([1, 7, 0]);
    expect(at('d')[0]).to.be.closeTo(3, 1e-5);
    expect(at('d')[1]).to.be.closeTo(7, 0.1);
    x3d.querySelector('#up')!.removeAttribute('translation');
    await wait(20);
    await until(() => at('f')[1] === 0);
    expect(at('f')).to.eql([1, 0, 0]);
    x3d.querySelector('#up')!.setAttribute('translation', '0 3 0');
    await wait(20);
    await until(() => at('f')[1] === 3);
    expect(at('f')).to.eql([1, 3, 0]);
  });

  it('an attribute written again with what it said is no edit', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t" translation="0 5 0"><shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.paused = true;
    world.advance(0.5);
    await drawn();
    const y = (world.node('b')!.get('position') as number[])[1];
    x3d.querySelector('#t')!.setAttribute('translation', '0 5 0');
    await wait(20);
    await drawn();
    expect((world.node('b')!.get('position') as number[])[1]).to.equal(y);
    expect(drawnAt(x3d.querySelector('#t')!)[1]).to.be.closeTo(y, 1e-5);
  });

  it('an authored position wins and moves the Transform', async () => {
    const { x3d, world } = await show(
      `
      <transform id="t" translation="0 5 0"><shape><box></box></shape><x3d-rigid-body id="b" fixed="true" position="1 1 1"></x3d-rigid-body></transform>`,
      '#b',
    );
    expect(world.node('b')!.get('position')).to.eql([1, 1, 1]);
    await drawn();
    expect(drawnAt(x3d.querySelector('#t')!)).to.eql([1, 1, 1]);
  });

  it('a moved Transform is drawn where its body is, at once', async () => {
    const { x3d, world } = await show(
      `<group id="g"></group>
      <transform id="t" translation="0 5 0"><shape><box></box></shape><x3d-rigid-body id="b"></x3d-rigid-body></transform>`,
      '#b',
    );
    world.paused = true;
    world.advance(0.5);
    const y = (world.node('b')!.get('position') as number[])[1];
    const transform = x3d.querySelector('#t')!;
    x3d.querySelector('#g')!.append(transform);
    await wait(20);
    await drawn();
    // x3dom lets go of it at once and reads it anew, on a slow machine later.
    await until(() => '_x3domNode' in transform);
    expect((world.node('b')!.get('position') as number[])[1]).to.equal(y);
    expect(drawnAt(transform)[1]).to.be.closeTo(y, 1e-5);
    expect(worldOf(transform)).to.equal(world);
  });
});
