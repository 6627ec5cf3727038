import { expect } from 'chai';
import '../../console.js';
import { open, worldIn, type PageWindow } from '../../page.js';
import { until } from '../../scene.js';

const refusedIn = (page: PageWindow): string[] =>
  (page as unknown as { refused: string[] }).refused.filter((file) => file.includes('/dist/'));

const root = (page: PageWindow, selector: string): ShadowRoot | null | undefined =>
  page.document.querySelector(selector)?.shadowRoot;

describe("under the security policy style-src 'self'", () => {
  for (const path of ['policy.html', 'policy.xhtml']) {
    it(`${path}: what helps to drag stays hidden, and nothing of ours is refused`, async () => {
      const page = await open(path);
      await worldIn(page);
      const handles = '.x3d-physics-handles';
      await until(() => root(page, handles)?.querySelector('button') != null);
      const box = page.document.querySelector(handles)!;
      expect(page.getComputedStyle(box).position).to.equal('absolute');
      for (const hidden of root(page, handles)!.querySelectorAll<HTMLElement>('p, button')) {
        expect(page.getComputedStyle(hidden).clipPath).to.equal('inset(50%)');
        expect(hidden.offsetWidth).to.be.at.most(1);
      }
      const button = root(page, handles)!.querySelector('button')!;
      button.focus();
      await until(() => button.offsetWidth > 14);
      expect(refusedIn(page)).to.eql([]);
    });

    it(`${path}: the page lays out no tags of the scene`, async () => {
      const page = await open(path);
      await worldIn(page);
      const scene = page.document.querySelector('scene, Scene')!;
      expect(page.getComputedStyle(scene).display).to.equal('none');
    });

    it(`${path}: the monitor and the chart look as they do elsewhere`, async () => {
      const page = await open(path);
      await worldIn(page);
      for (const tag of ['x3d-physics-monitor', 'x3d-accuracy-chart']) {
        // What loads above it grows, and pushes it out of sight again.
        await until(() => {
          page.document.querySelector(tag)!.scrollIntoView();
          return root(page, tag)?.querySelector('button') != null;
        });
        const button = root(page, tag)!.querySelector('button')!;
        expect(page.getComputedStyle(button).borderRadius, tag).to.not.equal('0px');
      }
      root(page, 'x3d-accuracy-chart')!.querySelector('button')!.click();
      await until(() => root(page, 'x3d-accuracy-chart')!.querySelector('svg') != null);
      expect(refusedIn(page)).to.eql([]);
    });
  }
});
