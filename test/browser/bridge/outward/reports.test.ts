import { expect } from 'chai';
import { claim } from '../../console.js';
import { place, show, until, wait } from '../../scene.js';

describe('reports', () => {
  it('make no world: the console and the page hear of what lives in none', async () => {
    claim('unknown-attribute', 'unused-collidable');
    const x3d = place('<x3d-collidable-shape id="s" colour="red"></x3d-collidable-shape>');
    const heard: string[] = [];
    x3d.addEventListener('physicsproblem', (event) =>
      heard.push(`${(event.target as Element).id} ${(event as CustomEvent).detail.code}`),
    );
    let ready = 0;
    x3d.addEventListener('physicsready', () => ready++);
    await until(() => heard.length > 1);
    await wait(100);
    expect([heard, ready]).to.eql([['s unknown-attribute', 's unused-collidable'], 0]);
  });

  it('of what stands outside any x3d show as a state, until it is put in', async () => {
    claim('misplaced');
    document.body.innerHTML = '<x3d-rigid-body></x3d-rigid-body>';
    const body = document.querySelector('x3d-rigid-body')!;
    await until(() => body.matches(':state(problem)'));
    const { x3d } = await show('<x3d-rigid-body-collection></x3d-rigid-body-collection>');
    x3d.querySelector('x3d-rigid-body-collection')!.append(body);
    await until(() => !body.matches(':state(problem)'));
  });

  it('of the world itself fire at its collection', async () => {
    const { x3d, world } = await show(
      '<x3d-rigid-body-collection id="c"></x3d-rigid-body-collection>',
      '#c',
    );
    const heard: unknown[] = [];
    x3d.addEventListener('physicsproblem', (event) =>
      heard.push([(event.target as Element).id, (event as CustomEvent).detail.code]),
    );
    claim('[something]');
    world.report({ code: 'something', severity: 'info', message: 'said' });
    expect(heard).to.eql([['c', 'something']]);
  });
});
