import assert from 'node:assert/strict';
import { describe } from 'node:test';
import type { EffectDescriptor } from '../../../../physics-core/effects/effect/effect.js';
import type { Effects } from '../../../../physics-core/effects/effect/effects.js';
import { Draws } from '../../../../physics-core/effects/particles/emit/draws.js';
import { particles } from '../../../../physics-core/effects/particles/effects.js';
import { BIRTH } from '../../../../physics-core/effects/particles/emit/emitter.js';
import { meshes } from '../../../../physics-core/inside.js';
import type { PhysicsNode } from '../../../../physics-core/nodes/node/node.js';
import { EmitterNode } from '../../../../physics-core/nodes/particles/emitter-node.js';
import { particleTypes } from '../../../../physics-core/nodes/particles/index.js';
import {
  BoundedModelNode,
  ForceModelNode,
  WindModelNode,
} from '../../../../physics-core/nodes/particles/model-node.js';
import { box, claim, fact, told, world } from '../../helpers.js';

const LINE = [0, 0, 0, 1, 0, 0];
const COORDINATE = { type: 'Coordinate', point: LINE };

/** Another value than the default, by field. */
const OTHER: Record<string, unknown> = {
  on: false,
  enabled: false,
  internal: false,
  speed: 3,
  variation: 0,
  mass: 1,
  surfaceArea: 1,
  angle: 1,
  gustiness: 1,
  turbulence: 1,
  position: [1, 2, 3],
  direction: [0, 0, 1],
  force: [1, 0, 0],
  coord: LINE,
  coordIndex: [0, 1],
  surface: { type: 'Sphere' },
  geometry: { type: 'Sphere' },
};

describe('what a ParticleSystem is made of', () => {
  fact('takes points as a Coordinate, or as its numbers in whatever list', async () => {
    const w = await world();
    const lists = [COORDINATE, LINE, Float32Array.from(LINE), [LINE.slice(0, 3), LINE.slice(3)]];
    for (const coord of [...lists, { type: 'Coordinate', point: '0 0 0, 1 0 0' }]) {
      const emitter = w.add('PolylineEmitter', { coord, coordIndex: [0, 1, -1] });
      assert.deepEqual(emitter.get('coord'), COORDINATE);
      emitter.event('coord', [0, 0, 0]);
      assert.deepEqual(emitter.get('coord'), { type: 'Coordinate', point: [0, 0, 0] });
      emitter.set('coord', []);
      assert.equal(emitter.get('coord'), null);
    }
  });

  fact('copies points, and the same points again are no edit', async () => {
    const w = await world();
    const point = [...LINE];
    const emitter = w.add('PolylineEmitter', { coord: { type: 'Coordinate', point } });
    point[0] = NaN;
    assert.deepEqual(emitter.get('coord'), COORDINATE);
    w.step();
    const { patched } = w.stats;
    for (let i = 0; i < 10; i++) emitter.set('coord', [...LINE]);
    w.step(0);
    assert.equal(w.stats.patched, patched);
    emitter.set('coord', [...LINE, 1, 1, 0]);
    w.step(0);
    assert.equal(w.stats.patched, patched + 1);
  });

  fact('tells of points that are none, and goes without them', async () => {
    const w = await world();
    claim(w, 'bad-value', 'misplaced', 'out-of-range');
    const emitter = w.add('PolylineEmitter', { coord: LINE });
    for (const point of [
      [1, 2],
      [1, 2, NaN],
      [1e10, 0, 0],
    ]) {
      emitter.set('coord', { type: 'Coordinate', point });
      assert.equal(emitter.get('coord'), null);
      assert.equal(told(w, 'bad-value').length, 1);
      emitter.set('coord', LINE);
    }
    for (const coord of [{ type: 'Sphere' }, w.add('RigidBody')]) {
      emitter.set('coord', coord);
      assert.equal(emitter.get('coord'), null);
      assert.equal(told(w, 'misplaced').length, 1);
    }
    emitter.set('coordIndex', [0, 1, -2]);
    assert.deepEqual(emitter.get('coordIndex'), [-1]);
  });

  fact('has its points again after a world went back', async () => {
    const w = await world();
    const emitter = w.add('PolylineEmitter', { coord: LINE, coordIndex: [0, 1, -1] });
    w.step();
    const before = w.snapshot();
    emitter.event('coordIndex', [1, 0, -1]);
    emitter.set('coord', [0, 0, 0]);
    w.step();
    const after = w.snapshot();
    w.restore(before);
    assert.deepEqual([emitter.get('coord'), emitter.get('coordIndex')], [COORDINATE, [0, 1, -1]]);
    w.restore(after);
    assert.deepEqual(
      [emitter.get('coord'), emitter.get('coordIndex')],
      [{ type: 'Coordinate', point: [0, 0, 0] }, [1, 0, -1]],
    );
  });

  fact('needs the code of meshes for geometry, whatever its kind, and not without', async () => {
    const w = await world();
    const coord = [...LINE, 0, 1, 0];
    const withMesh: [type: string, fields: Record<string, unknown>][] = [
      ['SurfaceEmitter', { surface: { type: 'Sphere' } }],
      ['VolumeEmitter', { coord }],
      ['BoundedPhysicsModel', { geometry: box(1) }],
    ];
    for (const [type, fields] of withMesh) {
      assert.deepEqual(w.add(type).needs, [], type);
      assert.deepEqual(w.add(type, fields).needs, [meshes], type);
    }
    assert.deepEqual(w.add('PolylineEmitter', { coord }).needs, []);
  });

  fact('says of each emitter what its fields say', async () => {
    const w = await world();
    const said = { on: false, mass: 2, surfaceArea: 3 };
    const all = ['Point', 'Cone', 'Explosion', 'Polyline', 'Surface', 'Volume'];
    for (const kind of all) {
      const emitter = w.add(`${kind}Emitter`, said) as PhysicsNode;
      assert.ok(emitter instanceof EmitterNode);
      assert.deepEqual(
        [emitter.emits, emitter.mass, emitter.surfaceArea, emitter.atOnce],
        [false, 2, 3, kind === 'Explosion'],
      );
    }
  });

  fact('bears particles where and as its fields say', async () => {
    await meshes.load();
    const w = await world();
    const born = (
      type: string,
      fields: Record<string, unknown>,
    ): [at: number[], going: number[]] => {
      const emitter = w.add(type, { variation: 0, ...fields }) as PhysicsNode as EmitterNode;
      const birth = new Float64Array(BIRTH);
      assert.ok(emitter.emitter.emit(new Draws(1).of(1), birth), type);
      return [[...birth.subarray(0, 3)], [...birth.subarray(3)]];
    };
    const from = { position: [1, 2, 3], speed: 2 };
    const up = { direction: [0, 9, 0] };
    assert.deepEqual(born('PointEmitter', { ...from, ...up }), [
      [1, 2, 3],
      [0, 2, 0],
    ]);
    for (const angle of [0, 1]) {
      const [at, going] = born('ConeEmitter', { ...from, ...up, angle });
      assert.deepEqual(at, [1, 2, 3]);
      assert.ok(going[1]! >= 2 * Math.cos(angle) - 1e-12 && going[1]! <= 2);
    }
    const [, apart] = born('ExplosionEmitter', from);
    assert.ok(Math.abs(Math.hypot(...apart) - 2) < 1e-12);
    const [[x, y, z], along] = born('PolylineEmitter', { coord: [5, 1, 0, 6, 1, 0], ...up });
    assert.ok(x! >= 5 && x! < 6 && y === 1 && z === 0);
    assert.deepEqual(along, [0, 0, 0]);
    const surface = { type: 'Rectangle2D', translation: [0, 0, 4] };
    const [on, away] = born('SurfaceEmitter', { surface, speed: 3 });
    assert.deepEqual([on[2], away], [4, [0, 0, 3]]);
    const coord = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
    const coordIndex = [0, 2, 1, -1, 0, 1, 3, -1, 1, 2, 3, -1, 2, 0, 3, -1];
    const [inside] = born('VolumeEmitter', { coord, coordIndex });
    assert.ok(Math.min(...inside) > 0 && inside[0]! + inside[1]! + inside[2]! < 1);
    const [outside] = born('VolumeEmitter', { coord, coordIndex, internal: false });
    const [a, b, c] = outside as [number, number, number];
    assert.ok(Math.min(a, b, c, Math.abs(1 - a - b - c)) < 1e-12);
  });

  fact('tells its systems of every edit, and when it goes', async () => {
    await meshes.load();
    const w = await world();
    const { registry } = w as unknown as { registry: Effects };
    const find = registry.find.bind(registry);
    let times = 0;
    const systems = { changed: () => times++, hear: () => {} };
    registry.find = ((asked: EffectDescriptor) =>
      asked.name === particles.name ? systems : find(asked)) as Effects['find'];
    for (const [type, { fields }] of Object.entries(particleTypes)) {
      if (type === 'ParticleSystem') continue;
      const part = w.add(type);
      w.step(0);
      for (const [name, field] of Object.entries(fields)) {
        if (field.edit === 'passive') continue;
        times = 0;
        part.set(name, OTHER[name]);
        w.step(0);
        assert.equal(times, 1, `${type}.${name}`);
      }
      part.remove();
      assert.equal(times, 2, type);
    }
  });

  fact('says of each model what its fields say', async () => {
    const w = await world();
    const force = w.add('ForcePhysicsModel', { enabled: false, force: [1, 2, 3] }) as PhysicsNode;
    assert.ok(force instanceof ForceModelNode);
    assert.deepEqual([force.enabled, force.force], [false, [1, 2, 3]]);
    const blows = { direction: [0, 0, 2], speed: 3, gustiness: 4, turbulence: 0.5 };
    const wind = w.add('WindPhysicsModel', blows) as PhysicsNode;
    assert.ok(wind instanceof WindModelNode);
    assert.deepEqual(wind.wind, blows);
    const bounds = w.add('BoundedPhysicsModel') as PhysicsNode;
    assert.ok(bounds instanceof BoundedModelNode);
    assert.deepEqual(bounds.mesh, { points: [], index: [] });
  });

  fact('has its geometry where it sits', async () => {
    await meshes.load();
    const w = await world();
    const geometry = {
      type: 'Mesh',
      points: [1, 0, 0, 0, 1, 0, 0, 0, 1],
      index: [0, 1, 2],
      linear: [2, 0, 0, 0, 1, 0, 0, 0, 1],
      rotation: [0, 0, 1, Math.PI / 2],
      translation: [0, 0, 5],
    };
    const bounds = w.add('BoundedPhysicsModel', { geometry }) as PhysicsNode as BoundedModelNode;
    const { points, index } = bounds.mesh;
    assert.deepEqual(index, [0, 1, 2]);
    const wanted = [0, 2, 5, -1, 0, 5, 0, 0, 6];
    points.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]!) < 1e-12, `${i}: ${value}`));
  });
});
