import { expect } from 'chai';
import { place, until, wait } from '../../scene.js';

describe('collisionstart and collisionend', () => {
  it('of an Inline fire at the Inline', async () => {
    const x3d = place('<inline id="file" url="/test/pages/settling-crate.x3d"></inline>');
    const inline = x3d.querySelector('inline')!;
    const starts: CustomEvent[] = [];
    inline.addEventListener('collisionstart', (event) => starts.push(event as CustomEvent));
    await until(() => starts.length > 0);
    expect(starts[0]!.target).to.equal(inline);
    const { def, element, node, other } = starts[0]!.detail;
    expect(element.getAttribute('DEF')).to.equal(def);
    expect(node.host).to.equal(element);
    expect(other).to.be.instanceOf(Element);
    // x3dom itself stumbles over an Inline that goes within a second of its coming.
    await wait(1100);
  });
});
