import { expect } from 'chai';
import { plain } from '../../forms.js';
import { openText, openUrl, type PageWindow } from '../../page.js';
import { until } from '../../scene.js';

// One scene with every node that simulates, in every form that authors write: the same motion, bit for bit.

const shape = (geometry: string): string =>
  `<x3d-collidable-shape><Shape>${geometry}</Shape></x3d-collidable-shape>`;
const body = (def: string, at: string, geometry: string, rest = ''): string =>
  `<x3d-rigid-body DEF="${def}" position="${at}" ${rest}>${shape(geometry)}</x3d-rigid-body>`;
const both = (first: string, second: string): string =>
  `<x3d-rigid-body USE="${first}" containerField="body1"></x3d-rigid-body><x3d-rigid-body USE="${second}" containerField="body2"></x3d-rigid-body>`;
const box = (size: string): string => `<Box size="${size}"></Box>`;

const SCENE = `
  <x3d-rigid-body-collection DEF="World">
    <x3d-rigid-body DEF="Ground" fixed="true" position="0 -0.5 0">${shape(box('50 1 50'))}</x3d-rigid-body>
    ${body('Car', '0 1 0', box('1 0.4 2'))}
    ${body('Wheel', '1 1 0', '<Sphere radius="0.4"></Sphere>')}
    ${body('Arm', '0 1 2', box('0.2 0.2 1'))}
    ${body('Tail', '0 1 -2', box('0.2 0.2 1'))}
    ${body('Flap', '-1.5 1 0', box('1 0.1 0.5'))}
    <x3d-rigid-body DEF="Pendant" position="0 2.5 0">
      <x3d-collidable-offset translation="0 -0.5 0"><x3d-collidable-shape><Shape>${box('0.3 0.3 0.3')}</Shape></x3d-collidable-shape></x3d-collidable-offset>
    </x3d-rigid-body>
    <x3d-double-axis-hinge-joint anchorPoint="1 1 0" axis1="0 1 0" axis2="1 0 0" desiredAngularVelocity2="3" maxTorque2="5">${both('Car', 'Wheel')}</x3d-double-axis-hinge-joint>
    <x3d-slider-joint axis="0 0 1" minSeparation="-0.5" maxSeparation="0.5">${both('Car', 'Arm')}</x3d-slider-joint>
    <x3d-universal-joint anchorPoint="0 1 -1" axis1="0 1 0" axis2="1 0 0">${both('Car', 'Tail')}</x3d-universal-joint>
    <x3d-single-axis-hinge-joint anchorPoint="-0.8 1 0" axis="0 0 1" minAngle="-0.5" maxAngle="0.5">${both('Car', 'Flap')}</x3d-single-axis-hinge-joint>
    <x3d-ball-joint anchorPoint="0 3 0">${both('Car', 'Pendant')}</x3d-ball-joint>
    <x3d-motor-joint enabledAxes="1" motor1Axis="1 0 0" axis1Torque="0.5">${both('Wheel', 'Car')}</x3d-motor-joint>
  </x3d-rigid-body-collection>
  <Transform translation="0 0.1 4"><x3d-collidable-shape DEF="Step"><Shape>${box('4 0.2 1')}</Shape></x3d-collidable-shape></Transform>
  <x3d-collision-collection DEF="Steps"><x3d-collision-space><x3d-collidable-shape USE="Step"></x3d-collidable-shape></x3d-collision-space></x3d-collision-collection>
  <x3d-collision-sensor><x3d-collision-collection USE="Steps" containerField="collider"></x3d-collision-collection></x3d-collision-sensor>`;

const scripts = ['/node_modules/x3dom/x3dom.js', '/dist/x3d-physics.classic.js']
  .map((path) => `<script src="${location.origin}${path}"></script>`)
  .join('');
const html = (scene: string): string => `<!DOCTYPE html><html><head>${scripts}</head>
  <body><x3d width="300px" height="200px"><scene>${scene}</scene></x3d></body></html>`;
const xhtml = (scene: string): string => `<?xml version="1.0" encoding="UTF-8"?>
  <html xmlns="http://www.w3.org/1999/xhtml"><head><title>x</title>${scripts}</head>
  <body><X3D width="300px" height="200px"><Scene>${scene}</Scene></X3D></body></html>`;
const file = (scene: string): string =>
  `<?xml version="1.0" encoding="UTF-8"?><X3D version="4.0"><Scene>${scene}</Scene></X3D>`;

const blob = (text: string, type: string): string =>
  URL.createObjectURL(new Blob([text], { type }));

/** Poses of all bodies after two seconds. */
async function motion(page: PageWindow): Promise<string> {
  let found: Element | undefined;
  const search = (root: ParentNode): void => {
    for (const each of root.querySelectorAll('*')) {
      if (/^(x3d-)?rigid-?body-?collection$/i.test(each.localName)) found ??= each;
      const inner = (each as unknown as { _x3domNode?: { _childNodes?: { _xmlNode: Element }[] } })
        ._x3domNode?._childNodes?.[0]?._xmlNode;
      if (/^inline$/i.test(each.localName) && inner) search(inner);
    }
  };
  await until(() => (search(page.document), found !== undefined && !!page.X3DPhysics));
  const world = await page.X3DPhysics!.worldOf(found!)!.ready;
  world.paused = true;
  world.reset();
  world.advance(2);
  const names = ['Car', 'Wheel', 'Arm', 'Tail', 'Flap', 'Pendant'];
  return JSON.stringify(
    names.map((name) => [world.node(name)!.get('position'), world.node(name)!.get('orientation')]),
  );
}

describe('one scene in every form', () => {
  it('moves by the same bits in HTML, XHTML and Inline, with plain and custom tags', async () => {
    const forms: Record<string, () => Promise<PageWindow>> = {
      'HTML, custom tags': () => openText(html(SCENE)),
      'HTML, plain tags': () => openText(html(plain(SCENE))),
      'XHTML, custom tags': () => openUrl(blob(xhtml(SCENE), 'application/xhtml+xml')),
      'XHTML, plain tags': () => openUrl(blob(xhtml(plain(SCENE)), 'application/xhtml+xml')),
      Inline: () =>
        openText(html(`<inline url="${blob(file(plain(SCENE)), 'model/x3d+xml')}"></inline>`)),
    };
    const [first, ...others] = Object.entries(forms);
    const expected = await motion(await first![1]());
    expect(expected).not.to.include('null');
    for (const [form, show] of others) expect(await motion(await show()), form).to.equal(expected);
  });
});
