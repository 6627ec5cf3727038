import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { bothSpellings } from '../../forms.js';
import { wait } from '../../scene.js';
import { scene, paused } from './contacts.js';

const reading = (world: { effects: { name: string; active: boolean }[] }): boolean =>
  world.effects.some(({ name, active }) => name === 'contact reading' && active);

describe('collisionstart and collisionend', () => {
  for (const [spelling, markup] of scene(1)) {
    for (const where of ['#ball', '#c', 'document'])
      it(`${spelling} tags: fire once each for who listens at ${where}, with the other element`, async () => {
        const { x3d, world } = await paused(markup);
        expect(reading(world)).to.equal(false);
        const target = where === 'document' ? document : x3d.querySelector(where)!;
        const heard: string[] = [];
        const details: Record<string, unknown>[] = [];
        const note = (event: Event): void => {
          const { detail } = event as CustomEvent;
          heard.push(`${(event.target as Element).id} ${event.type} ${detail.other.id}`);
          details.push(detail);
        };
        for (const name of ['collisionstart', 'collisionend']) target.addEventListener(name, note);
        expect(reading(world)).to.equal(true);
        world.advance(0.2);
        expect(heard).to.eql([]);
        world.advance(2);
        const mine = heard.filter((each) => each.startsWith('ball'));
        expect(mine).to.eql(['ball collisionstart floor']);
        expect(details[0]!.impulse).to.be.above(0);
        expect(details[0]!.contacts).to.have.property('length').above(0);
        expect(details[0]!.time).to.be.closeTo(Math.sqrt(1 / 9.8), 0.03);
        x3d.querySelector('#ball')!.setAttribute('position', '0 5 0');
        world.step(2);
        const ended = heard.filter((each) => each.startsWith('ball'));
        expect(ended).to.eql(['ball collisionstart floor', 'ball collisionend floor']);
        expect(details.at(-1)!.reason).to.equal('separated');
        for (const name of ['collisionstart', 'collisionend'])
          target.removeEventListener(name, note);
        world.step(1);
        expect(reading(world)).to.equal(false);
      });

    it(`${spelling} tags: a body that goes ends what it touched, for both`, async () => {
      const { x3d, world } = await paused(markup.replace('position="0 1 0"', 'position="0 0.5 0"'));
      const heard: string[] = [];
      for (const name of ['collisionstart', 'collisionend'])
        x3d.addEventListener(name, (event) =>
          heard.push(
            `${(event.target as Element).id} ${event.type} ${(event as CustomEvent).detail.reason}`,
          ),
        );
      world.advance(0.5);
      expect(heard.length).to.equal(2);
      const ball = x3d.querySelector('#ball')!;
      ball.remove();
      world.step(2);
      // The ball itself is no longer under those who listen: it ends where it stood.
      expect(heard.slice(2)).to.have.members([
        'c collisionend removed',
        'floor collisionend removed',
      ]);
    });

    it(`${spelling} tags: a body that goes is heard by its own listeners and by those around its last place, each once`, async () => {
      const { x3d, world } = await paused(markup.replace('position="0 1 0"', 'position="0 0.5 0"'));
      const ball = x3d.querySelector('#ball')!;
      const [own, around]: CustomEvent[][] = [[], []];
      ball.addEventListener('collisionend', (event) => own!.push(event as CustomEvent));
      const place = x3d.querySelector('#c')!;
      place.addEventListener('collisionend', (event) => around!.push(event as CustomEvent));
      world.advance(0.5);
      ball.remove();
      world.step(2);
      expect(own!.map(({ detail }) => detail.reason)).to.eql(['removed']);
      const its = around!.filter(({ target }) => target === place);
      expect(its.map(({ detail }) => [detail.element, detail.reason])).to.eql([[ball, 'removed']]);
      place.append(ball);
      world.reset();
      world.advance(0.5);
      ball.setAttribute('position', '0 9 0');
      world.step(2);
      expect(around!.at(-1)!.target).to.not.equal(place);
      expect(own!.length).to.equal(2);
    });
  }

  it('show as a state while somebody listens, in explain always', async () => {
    const { x3d, world } = await paused(scene(0.5)[0]![1]);
    const ball = x3d.querySelector('#ball')!;
    world.advance(0.5);
    expect(ball.matches(':state(colliding)')).to.equal(false);
    expect(explain(ball).touches!.map((each) => x3d.querySelector(each))).to.eql([
      x3d.querySelector('#floor'),
    ]);
    const note = (): void => {};
    ball.addEventListener('collisionend', note);
    world.advance(0.5);
    expect(ball.matches(':state(colliding)')).to.equal(true);
    expect(explain(ball).touches!.map((each) => x3d.querySelector(each))).to.eql([
      x3d.querySelector('#floor'),
    ]);
    ball.removeEventListener('collisionend', note);
    expect(ball.matches(':state(colliding)')).to.equal(false);
    world.step(1);
    expect(reading(world)).to.equal(false);
  });

  for (const [spelling, markup] of scene(0.5)) {
    it(`${spelling} tags: listeners replaced with each rendering hear a lasting contact start once`, async () => {
      const { x3d, world } = await paused(markup);
      const ball = x3d.querySelector('#ball')!;
      let starts = 0;
      const inline = (): EventListener => () => void starts++;
      let listener = inline();
      ball.addEventListener('collisionstart', listener);
      for (let frame = 0; frame < 60; frame++) {
        world.step(2);
        // Between frames in two tasks, or within one.
        ball.removeEventListener('collisionstart', listener);
        if (frame % 20 === 0) await wait(0);
        listener = inline();
        ball.addEventListener('collisionstart', listener);
      }
      expect(starts).to.equal(1);
      if (spelling === 'custom') expect(ball.matches(':state(colliding)')).to.equal(true);
    });

    it(`${spelling} tags: a listener that takes a body away within a step is told of its end, and so is what stands around`, async () => {
      for (const event of ['collisionstart', 'beforestep', 'afterstep']) {
        const { x3d, world } = await paused(markup);
        const ball = x3d.querySelector('#ball')!;
        const around = x3d.querySelector('#c')!;
        const heard: string[] = [];
        for (const name of ['collisionstart', 'collisionend'])
          around.addEventListener(name, ({ type, target, detail }: CustomEventInit & Event) => {
            const { element = target, reason, other } = detail;
            const { id } = element as Element;
            heard.push(`${id} ${type} ${reason ?? ''} ${other.id}`);
          });
        if (event !== 'collisionstart') world.advance(0.1);
        around.addEventListener(event, () => ball.remove());
        world.advance(0.2);
        expect(heard, event).to.have.members([
          'ball collisionstart  floor',
          'floor collisionstart  ball',
          'ball collisionend removed floor',
          'floor collisionend removed ball',
        ]);
        x3d.remove();
      }
    });

    it(`${spelling} tags: who hears that one of several bodies went finds all of them gone`, async () => {
      const more = '<x3d-rigid-body id="more" position="3 0.5 0"></x3d-rigid-body>';
      const [[, custom], [, plain]] = bothSpellings(more) as [[string, string], [string, string]];
      const end = spelling === 'custom' ? '</x3d-rigid-body-collection>' : '</RigidBodyCollection>';
      const { x3d, world } = await paused(
        markup.replace(end, `${spelling === 'custom' ? custom : plain}${end}`),
      );
      const bodies: number[] = [];
      x3d.querySelector('#floor')!.addEventListener('collisionend', () => {
        world.step(1);
        bodies.push(world.stats.bodies);
      });
      world.advance(0.1);
      expect(world.stats.bodies).to.equal(3);
      for (const id of ['ball', 'more']) x3d.querySelector(`#${id}`)!.remove();
      await wait(0);
      expect(bodies).to.eql([1]);
    });
  }
});
