import { expect } from 'chai';
import { explain } from '../../../../elements/index.js';
import { bothSpellings } from '../../forms.js';
import { place, show, until, wait } from '../../scene.js';

type Contact = Record<string, unknown> & {
  geometry1: Element;
  geometry2: Element;
  position: number[];
  depth: number;
};
interface Sensor extends Element {
  contacts: Contact[];
  intersections: Element[];
  isActive: boolean;
}
interface Collection extends Element {
  set_contacts: unknown;
  setFieldValue(name: string, value: unknown): void;
}

const position = (world: { node(name: string): unknown }, name: string): number[] =>
  (world.node(name) as { get(field: string): number[] }).get('position');
const reading = (world: { effects: { name: string; active: boolean }[] }): boolean =>
  world.effects.some(({ name, active }) => name === 'contact reading' && active);

/** A ball of 0.5 m that lies on a floor whose upper side is at 0, or falls on it. */
const scene = (height: number, rest = ''): [string, string][] =>
  bothSpellings(`
    <x3d-rigid-body-collection id="c" def="C">
      <x3d-rigid-body id="floor" fixed="true" position="0 -0.5 0">
        <x3d-collidable-shape def="floorshape"><shape><box size="10 1 10"></box></shape></x3d-collidable-shape>
      </x3d-rigid-body>
      <x3d-rigid-body id="ball" position="0 ${height} 0">
        <x3d-collidable-shape def="ballshape"><shape><sphere radius="0.5"></sphere></shape></x3d-collidable-shape>
      </x3d-rigid-body>
    </x3d-rigid-body-collection>${rest}`);

const SENSOR = `
  <x3d-collision-sensor id="sensor" def="S">
    <x3d-collision-collection id="k" appliedparameters='"BOUNCE"'>
      <x3d-collidable-shape use="floorshape"></x3d-collidable-shape><x3d-collidable-shape use="ballshape"></x3d-collidable-shape>
    </x3d-collision-collection>
  </x3d-collision-sensor>`;
const ROUTE = '<ROUTE fromNode="S" fromField="contacts" toNode="C" toField="set_contacts"></ROUTE>';

async function paused(markup: string) {
  const shown = await show(markup, '#c');
  shown.world.paused = true;
  shown.world.reset();
  return shown;
}

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

  it('of an Inline fire at the Inline', async () => {
    const x3d = place('<inline id="file" url="/test/pages/settling-crate.x3d"></inline>');
    const inline = x3d.querySelector('inline')!;
    const starts: CustomEvent[] = [];
    inline.addEventListener('collisionstart', (event) => starts.push(event as CustomEvent));
    await until(() => starts.length > 0, 10_000);
    expect(starts[0]!.target).to.equal(inline);
    const { def, element, node, other } = starts[0]!.detail;
    expect(element.getAttribute('DEF')).to.equal(def);
    expect(node.host).to.equal(element);
    expect(other).to.be.instanceOf(Element);
    // x3dom itself stumbles over an Inline that goes within a second of its coming.
    await wait(1100);
  });
});

describe('CollisionSensor', () => {
  for (const [spelling, markup] of scene(0.5, SENSOR)) {
    it(`${spelling} tags: says what touches as elements, by event and by value`, async () => {
      const { x3d, world } = await paused(markup);
      const sensor = x3d.querySelector('#sensor') as Sensor;
      const heard: [string, unknown][] = [];
      sensor.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: unknown };
        heard.push([fieldName, value]);
      });
      world.advance(0.5);
      const shapes = ['floorshape', 'ballshape'].map((name) => x3d.querySelector(`[def=${name}]`));
      expect(heard.filter(([name]) => name === 'isActive')).to.eql([['isActive', true]]);
      const lists = heard.filter(([name]) => name === 'intersections').map(([, value]) => value);
      expect(lists.at(-1)).to.have.members(shapes);
      const contacts = heard.filter(([name]) => name === 'contacts').map(([, value]) => value);
      const [contact] = contacts.at(-1) as Contact[];
      expect([contact!.geometry1, contact!.geometry2]).to.have.members(shapes);
      expect(contact!.position[1]).to.be.closeTo(0, 0.01);
      x3d.querySelector('#ball')!.setAttribute('position', '0 5 0');
      world.step(3);
      expect(heard.slice(-3).map(([name, value]) => [name, value])).to.deep.include.members([
        ['isActive', false],
        ['intersections', []],
        ['contacts', []],
      ]);
      if (spelling === 'custom') {
        expect([sensor.isActive, sensor.intersections, sensor.contacts]).to.eql([false, [], []]);
        x3d.querySelector('#ball')!.setAttribute('position', '0 0.5 0');
        world.advance(0.2);
        expect(sensor.isActive).to.equal(true);
        expect(sensor.intersections).to.have.members(shapes);
        expect(sensor.contacts[0]!.depth).to.be.closeTo(0, 0.01);
      }
    });
  }
});

describe('a ROUTE from a CollisionSensor', () => {
  for (const [spelling, markup] of scene(
    0.5,
    `${SENSOR}<ROUTE fromNode="S" fromField="isActive" toNode="FREE" toField="fixed"></ROUTE>`,
  ))
    it(`${spelling} tags: sends each change once, and FALSE where the world begins anew`, async () => {
      const free = bothSpellings(
        '<x3d-rigid-body def="FREE" id="free" position="9 9 0"></x3d-rigid-body>',
      );
      const [, body] = free.find(([name]) => name === spelling)!;
      const { x3d, world } = await paused(`${markup}${body}`);
      const sensor = x3d.querySelector('#sensor')!;
      const sent: unknown[] = [];
      sensor.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: unknown };
        if (fieldName === 'isActive') sent.push(value);
      });
      world.advance(0.2);
      expect(sent).to.eql([true]);
      world.reset();
      expect(sent).to.eql([true, false]);
      world.advance(0.2);
      expect(sent).to.eql([true, false, true]);
    });
});

describe('set_contacts', () => {
  for (const [spelling, markup] of scene(0.5, SENSOR + ROUTE))
    it(`${spelling} tags: ROUTEd from a sensor nothing changes`, async () => {
      const { world } = await paused(markup);
      world.advance(2);
      expect(position(world, 'ball')[1]).to.be.closeTo(0.5, 0.01);
    });

  for (const [spelling, markup] of scene(0.5, SENSOR)) {
    it(`${spelling} tags: contacts that page code drops do not push`, async () => {
      const { x3d, world } = await paused(markup);
      const collection = x3d.querySelector('#c') as Collection;
      const sensor = x3d.querySelector('#sensor')!;
      const drop = (event: Event): void => {
        if ((event as unknown as { fieldName: string }).fieldName === 'contacts')
          collection.setFieldValue('set_contacts', []);
      };
      sensor.addEventListener('outputchange', drop);
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.below(-0.3);
    });

    it(`${spelling} tags: what is listened to and not handed back pushes`, async () => {
      const { x3d, world } = await paused(markup);
      x3d.querySelector('#sensor')!.addEventListener('outputchange', () => {});
      world.advance(0.5);
      expect(position(world, 'ball')[1]).to.be.closeTo(0.5, 0.01);
    });

    it(`${spelling} tags: contacts that page code changes act as changed`, async () => {
      const { x3d, world } = await paused(markup);
      const collection = x3d.querySelector('#c') as Collection;
      let given = 0;
      x3d.querySelector('#sensor')!.addEventListener('outputchange', (event) => {
        const { fieldName, value } = event as unknown as { fieldName: string; value: Contact[] };
        if (fieldName !== 'contacts') return;
        given += value.length;
        const changed = value.map((contact) => ({
          ...contact,
          frictionCoefficients: [0.0001, 0.0001],
          bounce: 0,
        }));
        collection.setFieldValue('set_contacts', changed);
      });
      x3d.querySelector('#ball')!.setAttribute('linearvelocity', '1 0 0');
      world.advance(1);
      expect(given).to.be.above(0);
      // Without friction it slides on and does not roll; only in the first step nobody knew of the contact yet.
      const ball = world.node('ball') as unknown as { get(field: string): number[] };
      expect(ball.get('linearVelocity')[0]).to.be.closeTo(1, 0.05);
      expect(Math.abs(ball.get('angularVelocity')[2]!)).to.be.below(0.3);
    });
  }

  it('takes plain objects and Contact elements of the page’s own making', async () => {
    const { x3d, world } = await paused(scene(3)[0]![1]);
    const collection = x3d.querySelector('#c') as Collection;
    const [ball, floor] = ['ballshape', 'floorshape'].map((name) =>
      x3d.querySelector(`[def=${name}]`)!,
    );
    const own = {
      geometry1: ball,
      geometry2: floor,
      position: [0, 2.5, 0],
      contactNormal: [0, 1, 0],
      depth: 0.001,
    };
    const element = Object.assign(document.createElement('x3d-contact'), own);
    for (const given of [own, element]) {
      world.reset();
      const give = (): void => void (collection.set_contacts = [given]);
      x3d.addEventListener('beforestep', give);
      world.advance(0.5);
      x3d.removeEventListener('beforestep', give);
      expect(position(world, 'ball')[1]).to.be.closeTo(3, 0.05);
      world.advance(0.3);
      expect(position(world, 'ball')[1]).to.be.below(2.8);
    }
  });
});
