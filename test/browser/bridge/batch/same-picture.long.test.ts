import { expect } from 'chai';
import '../../console.js';
import { drawn, until } from '../../scene.js';
import {
  bodies,
  colored,
  covered,
  difference,
  draws,
  drawPlainly,
  errorOf,
  picture,
  showBatched,
  wrapped,
} from './pictures.js';

const COUNT = 40;
const boxes = bodies(COUNT, (i) => `${colored(i)}<box size="1 1 1"></box>`);
const DARK = '<navigationinfo headlight="false"></navigationinfo>';
const FLOOR = `<transform translation="0 -4.5 0"><shape>${colored(4)}<box size="30 0.5 30"></box></shape></transform>`;
/** 4 × 4, red, green, blue and white. */
const IMAGE =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAAIUlEQVR42mP4r6Gh8V/DxuY/EDDAWUBRBjgLKMoAZwFFAd/yHEkDM/Y9AAAAAElFTkSuQmCC';
const FACES = `<indexedfaceset coordindex="0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1">
  <coordinate point="-0.6 -0.5 -0.4 0.6 -0.5 -0.4 0 0.7 -0.2 0 0 0.8"></coordinate></indexedfaceset>`;

/** All that x3dom's shaders take of a corner. */
const FULL_FACES = FACES.replace(
  'coordindex',
  'solid="false" colorpervertex="true" coordindex',
).replace(
  '</indexedfaceset>',
  `<color color="1 0 0 0 1 0 0 0 1 1 1 0"></color>
  <normal vector="-0.7 -0.5 -0.4 0.7 -0.5 -0.4 0 1 -0.2 0 0 1"></normal>
  <texturecoordinate point="0 0 1 0 0.5 1 0.5 0.5"></texturecoordinate></indexedfaceset>`,
);

const SCENES: Record<string, string> = {
  'boxes by the headlight': boxes,
  'boxes of many sizes': bodies(
    COUNT,
    (i) => `${colored(i)}<box size="${0.5 + (i % 4) / 4} ${0.4 + (i % 3) / 3} 1"></box>`,
  ),
  spheres: bodies(
    COUNT,
    (i) => `${colored(i, 'specularcolor="0.5 0.5 0.5"')}<sphere radius="0.6"></sphere>`,
  ),
  cylinders: bodies(COUNT, (i) => `${colored(i)}<cylinder radius="0.4" height="1"></cylinder>`),
  cones: bodies(COUNT, (i) => `${colored(i)}<cone bottomradius="0.5" height="1"></cone>`),
  'an IndexedFaceSet': bodies(COUNT, (i) => colored(i) + FACES),
  'an IndexedFaceSet with colours, normals and a texture': bodies(
    COUNT,
    () =>
      `<appearance><material></material><imagetexture url="${IMAGE}"></imagetexture></appearance>${FULL_FACES}`,
  ),
  'a DirectionalLight': `${DARK}<directionallight direction="-0.5 -1 -0.7" ambientintensity="0.3"></directionallight>${boxes}`,
  'a PointLight': `${DARK}<pointlight location="3 4 5"></pointlight>${boxes}`,
  'a SpotLight': `${DARK}<spotlight location="0 0 9" direction="0 0 -1" cutoffangle="0.6" beamwidth="0.3"></spotlight>${boxes}`,
  'fog, of another kind': `<fog fogtype="EXPONENTIAL" visibilityrange="30" color="0.5 0.6 0.8"></fog>${boxes}`,
  fog: `<fog visibilityrange="20" color="0.5 0.6 0.8"></fog>${boxes}`,
  'a texture': bodies(
    COUNT,
    () =>
      `<appearance><material></material><imagetexture url="${IMAGE}"></imagetexture></appearance><box size="1 1 1"></box>`,
  ),
  'no Appearance': bodies(COUNT, () => '<box size="1 1 1"></box>'),
  'geometry and Appearance by USE': bodies(COUNT, (i) =>
    i === 0
      ? `<appearance def="A">${'<material diffusecolor="0.2 0.5 0.9"></material>'}</appearance><box def="B" size="1 1 1"></box>`
      : '<appearance use="A"></appearance><box use="B"></box>',
  ),
  'scaled by their own Transforms, unevenly': bodies(
    COUNT,
    (i) => `${colored(i)}<sphere radius="0.6"></sphere>`,
    'scale="1 0.5 0.8"',
  ),
  'under Transforms that turn, scale and mirror': `<transform translation="1 1 0" rotation="0 0 1 0.5" scale="-1 0.7 1.2"><group>${boxes}</group></transform>`,
  'each in groups of its own': wrapped(boxes),
  'each in a Group of its own, cones': bodies(
    COUNT,
    (i) => `${colored(i)}<cone bottomradius="0.5" height="1"></cone>`,
  )
    .replaceAll('<transform', '<group><transform')
    .replaceAll('</transform>', '</transform></group>'),
  'under a Switch': `<switch whichchoice="0"><group>${boxes}</group></switch>`,
  'in an Inline': '<inline url="/test/pages/bricks.x3d"></inline>',
};

/** WebKitGTK shows none of x3dom's shadows, however it draws. */
const SHOWS_SHADOWS = /Chrome\/|Firefox\//.test(navigator.userAgent);
const SHADOWS: Record<string, string> = {
  DirectionalLight: `<directionallight direction="-1 -1 -1" shadowintensity="0.7" znear="1" zfar="60"></directionallight>`,
  SpotLight: `<spotlight location="4 9 9" direction="-4 -9 -9" cutoffangle="0.9" beamwidth="0.5" radius="60" shadowintensity="0.7" shadowcascades="2"></spotlight>`,
  PointLight: `<pointlight location="2 6 5" radius="60" shadowintensity="0.7"></pointlight>`,
};

describe('bodies that look alike, drawn in one call', () => {
  for (const [what, scene] of Object.entries(SCENES))
    it(`look as they do drawn one by one: ${what}`, async () => {
      const { x3d, collection } = await showBatched(scene, 1);
      // A texture comes later.
      await until(() => covered(picture(x3d)) > 500);
      const together = picture(x3d);
      await drawPlainly(collection, true);
      expect(draws(x3d)).to.be.at.least(10);
      expect(difference(together, picture(x3d))).to.eql({ any: 0, most: 0 });
      await drawPlainly(collection, false);
      expect(draws(x3d)).to.equal(1);
      expect(difference(together, picture(x3d))).to.eql({ any: 0, most: 0 });
      expect(errorOf(x3d)).to.equal(0);
    });

  for (const [light, element] of Object.entries(SHADOWS))
    for (const groups of [false, true])
      it(`look as they do drawn one by one: shadows of ${light}${groups ? ', each in groups of its own' : ''}`, async () => {
        const { x3d, collection } = await showBatched(
          DARK + element + (groups ? wrapped(boxes) : boxes) + FLOOR,
        );
        const together = picture(x3d);
        await drawPlainly(collection, true);
        expect(draws(x3d)).to.be.above(COUNT);
        expect(difference(together, picture(x3d))).to.eql({ any: 0, most: 0 });
        expect(errorOf(x3d)).to.equal(0);
        x3d.querySelector(light)!.setAttribute('shadowIntensity', '0');
        await drawn();
        const shadowed = difference(together, picture(x3d)).any;
        if (SHOWS_SHADOWS) expect(shadowed).to.be.above(500);
        else expect(shadowed).to.equal(0);
      });

  it('look as they do drawn one by one wherever somebody looks from', async () => {
    const { x3d, collection } = await showBatched(
      `<navigationinfo transitiontype="TELEPORT"></navigationinfo>${boxes}`,
      1,
    );
    const viewpoint = x3d.querySelector('viewpoint')!;
    const look = async (i: number) => {
      viewpoint.setAttribute('position', `${3 * Math.sin(i)} ${i - 2.2} ${9 + i / 3}`);
      viewpoint.setAttribute('orientation', `${0.3 * i} 1 0.1 ${0.2 * Math.sin(i)}`);
      await drawn();
      return picture(x3d);
    };
    const together = [await look(0), await look(1), await look(2), await look(3), await look(4)];
    expect(draws(x3d)).to.equal(1);
    await drawPlainly(collection, true);
    for (const [i, one] of together.entries())
      expect(difference(one, await look(i)), `${i}`).to.eql({ any: 0, most: 0 });
    expect(difference(together[0]!, together[1]!).any).to.be.above(500);
  });
});
