// What each scene of the gallery comes to: facts of physics, in words of its own page. `body(id)`, `all(selector)`, `text(id)`
// and `seen`, what `each` answered every twentieth of a second, are there; so are `start` (places of all bodies by id or order)
// and `moved(bodies)`, how far each is from its start. A fact answers whether it holds.
export interface Fact {
  says: string;
  /** Seconds of the world until it is asked. */
  seconds: number;
  /** Done before the first step. */
  first?: string;
  /** Looked at in between. */
  each?: string;
  holds: string;
}

/** Metres by which the joints of a page gape at most. */
const GAP = `Math.max(...all('x3d-ball-joint, x3d-single-axis-hinge-joint').map((joint) =>
  Math.hypot(...joint.body1AnchorPoint.map((value, i) => value - joint.body2AnchorPoint[i]))))`;

export const FACTS: Record<string, Fact> = {
  trebuchet: {
    says: 'the sling lets go, and the stone strikes bricks out of the wall',
    seconds: 5,
    holds: `!document.getElementById('hook') && moved(all('.brick')).filter((way) => way > 0.3).length >= 5`,
  },
  cards: {
    says: 'for ten seconds no card moves by a millimetre',
    seconds: 10,
    holds: `all('.card').length === 26 && Math.max(...moved(all('.card'))) < 0.001`,
  },
  drum: {
    says: 'it turns as fast as it is told, lifts its load and loses none of it',
    seconds: 6,
    each: `Math.max(...all('.piece').map((piece) => piece.position[1]))`,
    holds: `Math.abs(body('body').angularVelocity[2] + 3.67) < 0.1 && Math.max(...seen.slice(40)) > 0.7 &&
      all('.piece').every(({ position: [x, y, z] }) => Math.hypot(x, y) < 1.4 && Math.abs(z) < 0.6)`,
  },
  'sand-wheel': {
    says: 'nothing but sand turns the wheel, and soon as fast as it will',
    seconds: 6,
    each: `body('wheel').angularVelocity[2]`,
    holds: `seen.slice(60).every((rate) => rate < -4 && rate > -7) && body('sand').count > 800`,
  },
  sparks: {
    says: 'sparks fly as fast as the rim runs, and none goes through the floor or what stands on it',
    seconds: 4,
    each: `body('sparks').positions`,
    holds: `Math.abs(body('wheel').angularVelocity[2] + 14) < 0.1 && seen.at(-1).length > 500 &&
      seen.flat().every(([x, y, z]) => y > -0.001 || x > 5.9 || Math.abs(z) > 2.4) && Math.max(...seen.flat().map(([x]) => x)) > 2.5`,
  },
  fountain: {
    says: 'boxes on axles go on turning under the drops, all of them inwards, and no drop goes through the floor',
    seconds: 6,
    each: `[all('.wheel').map(({ angularVelocity: [x, , z] }, i) => {
      const angle = ((2 * i + 1) * Math.PI) / 4;
      return z * Math.sin(angle) - x * Math.cos(angle);
    }), body('water').positions]`,
    holds: `all('.wheel').length === 4 && all('.wheel').every((_, i) =>
        seen.slice(60).reduce((sum, [rates]) => sum + rates[i], 0) > 0.5 * seen.slice(60).length) &&
      seen.at(-1)[1].length > 800 && seen.flatMap(([, drops]) => drops).every(([, y]) => y > 0)`,
  },
  snow: {
    says: 'flakes lie on a car that drives slowly, and leave one that drives fast; none is in the ground',
    seconds: 15,
    each: `(() => {
      const speed = body('speed');
      if (world.time > 9 && speed.value !== '4') {
        speed.value = 4;
        speed.dispatchEvent(new Event('input'));
      }
      const [x, y, z] = body('car').position;
      const flakes = body('snow').positions;
      // On its roof, which is 0.48 m above its middle; flakes are balls of 0.05 m, and a wheel may press one in by so much.
      return [flakes.filter((flake) => Math.abs(flake[1] - y - 0.53) < 0.01 && Math.hypot(flake[0] - x, flake[2] - z) < 0.9).length,
        flakes.filter((flake) => Math.hypot(flake[0], flake[2]) < 4.7 && flake[1] < -0.05 && flake[1] > -0.55).length, Math.hypot(x, z)];
    })()`,
    holds: `Math.max(...seen.slice(0, 180).map(([on]) => on)) >= 6 && Math.max(...seen.slice(-20).map(([on]) => on)) <= 3 &&
      seen.every(([, inGround]) => inGround === 0) && seen.every(([, , far]) => Math.abs(far - 2.6) < 0.6)`,
  },
  dust: {
    says: 'no dust before the stone strikes, then puffs where it does and where slabs fall, and the tower is down',
    seconds: 7,
    each: `all('.puff').filter(({ count }) => count > 0).map(({ positions }) => positions[0])`,
    holds: `seen[7].length === 0 && Math.max(...seen.map(({ length }) => length)) >= 8 && seen.at(-1).length <= 2 &&
      Math.abs(seen[11][0][0]) < 2 && seen[11][0][1] > 0.5 && moved(all('.slab')).filter((way) => way > 1).length >= 8`,
  },
  smoke: {
    says: 'smoke goes with the wind, round the tower and not into it, and rises straight where there is none',
    seconds: 12,
    each: `(world.time > 6 && (body('speed').value = 0), body('smoke').positions)`,
    holds: `(() => {
      const middle = (puffs) => puffs.reduce((sum, [x]) => sum + x, 0) / puffs.length;
      return middle(seen[110]) > -1 && Math.abs(middle(seen.at(-1)) + 3.1) < 0.2 &&
        seen.flat().every(([x, y, z]) => y > 3.9 || Math.hypot(x - 0.9, z) > 0.9);
    })()`,
  },
  'rope-bridge': {
    says: 'the roller goes over and comes back, the ropes give way under it and are no longer than they were laid',
    seconds: 9,
    each: `[body('roller').position, Math.min(...body('rope0').positions.map(([, y]) => y)), Math.max(...[0, 1].map((side) => {
      const { positions } = body('rope' + side);
      return positions.slice(1).reduce((sum, at, i) => sum + Math.hypot(...at.map((value, k) => value - positions[i][k])), 0);
    })), all('.plank').map(({ position }) => position[1])]`,
    holds: `Math.max(...seen.map(([[x]]) => x)) > 3.3 && seen.at(-1)[0][0] < 1 && seen.every(([[, y]]) => y > 0.2) &&
      seen.some(([, low]) => low < -0.33) && seen.every(([, , long]) => Math.abs(long - seen[0][2]) < 1e-5) &&
      seen.every(([, , , planks]) => planks.every((y) => y > -0.5 && y < 0.05))`,
  },
  derrick: {
    says: 'half a tonne goes after the beam, swings as a pendulum of its length, and its rope stretches by no millimetre',
    seconds: 12,
    each: `(asked.slew = world.time < 1.5 ? -1 : 0, (() => {
      const { positions } = body('rope');
      return [positions.slice(1).reduce((sum, at, i) => sum + Math.hypot(...at.map((value, k) => value - positions[i][k])), 0),
        body('load').position[2] - positions[0][2], body('load').position[1]];
    })())`,
    holds: `(() => {
      const sides = seen.slice(60).map(([, z]) => z);
      // From its middle to the load's: 3.59 m of rope and half a metre.
      const passes = sides.flatMap((z, i) => (i && sides[i - 1] < 0 && z >= 0 ? [i - z / (z - sides[i - 1])] : []));
      const period = (0.05 * (passes.at(-1) - passes[0])) / (passes.length - 1);
      return seen.every(([long]) => Math.abs(long - 3.5862) < 0.001) && Math.max(...sides) > 0.2 &&
        Math.abs(period / (2 * Math.PI * Math.sqrt(4.09 / 9.8)) - 1) < 0.05 && seen.every(([, , y]) => y > 1.4);
    })()`,
  },
  tetherball: {
    says: 'the rope winds round its post and does not go into it, until the ball is at it; then it winds off again',
    seconds: 6,
    each: `[Math.hypot(body('ball').position[0], body('ball').position[2]), body('rope').positions, wound()]`,
    holds: `Math.min(...seen.map(([far]) => far)) < 0.3 && Math.max(...seen.map(([, , turns]) => turns)) > 2.2 &&
      seen.at(-1)[2] < 1 &&
      seen.every(([, points]) => points.every(([x, y, z]) => y > 2.5 || Math.hypot(x, z) > 0.1)) &&
      seen.every(([, points]) => Math.hypot(...points.at(-1).map((value, k) => value - points[0][k])) < 1.84)`,
  },
  flags: {
    says: 'flags stand in the wind, hang when it drops, and no thread is longer by a thousandth',
    seconds: 14,
    each: `(world.time > 6 && (body('speed').value = 0), all('.flag').map(({ positions }) => {
      const row = (r) => positions.slice(15 * r, 15 * r + 15);
      const long = (points) => points.slice(1).reduce((sum, at, i) => sum + Math.hypot(...at.map((value, k) => value - points[i][k])), 0);
      const [x, , z] = positions[5 * 15 + 14];
      return [Math.hypot(x + 0.45, z), Math.max(...Array.from({ length: 11 }, (_, r) => long(row(r))))];
    }))`,
    holds: `seen.flat().every(([, long]) => long < 1.5 * 1.001 + 0.0005) && seen.slice(40, 120).every((flags) => flags.every(([out]) => out > 1)) &&
      seen.slice(-20).every((flags) => flags.every(([out]) => out < 0.75))`,
  },
  statue: {
    says: 'the cloth falls over the statue and not into it, and comes off it where it is taken',
    seconds: 7,
    each: `(world.time > 4 && body('lift').click(), (() => {
      const { positions } = body('cloth');
      // Each ring of the statue is seen from its axis: from outside nothing of it is before a point of the cloth, but for a millimetre of rounding.
      const isIn = ([x, y, z]) => {
        const far = Math.hypot(x, z);
        if (y < 0.55 || far > 0.5 || far < 0.02) return false;
        const [u, w] = [x / far, z / far];
        const hit = world.raycast([3 * u, y, 3 * w], [x + 0.002 * u, y, z + 0.002 * w]);
        return hit?.element === body('statue');
      };
      const whole = Math.round(20 * world.time) % 10 === 0;
      return [Math.max(...positions.map(([, y]) => y)), Math.min(...positions.map(([, y]) => y)), whole ? positions.filter(isIn).length : 0];
    })())`,
    holds: `seen.every(([, , into]) => into === 0) && Math.abs(seen[75][0] - 1.95) < 0.03 && seen[75][1] < 0.9 && seen[75][1] > 0 && seen.at(-1)[1] > 1.4`,
  },
  jelly: {
    says: 'it goes along with a plate that goes slowly, sways many times as far at its own beat, and sticks to it by a centimetre',
    seconds: 10,
    each: `(body('beat').value = world.time < 5 ? 1 : 2.2, [body('cherry').position[0] - body('plate').getAttribute('translation').split(' ')[0],
      ...body('jelly').positions[2 * 48].map((value, k) => value - [0.5275, 0.003, 0][k] - (k === 0 ? +body('plate').getAttribute('translation').split(' ')[0] : 0))])`,
    holds: `(() => {
      // It leans a little, too, as what bears something at its top may: that is no swing.
      const swing = (from, to) => {
        const sways = seen.slice(20 * from, 20 * to).map(([sway]) => sway);
        return Math.max(...sways) - Math.min(...sways);
      };
      return swing(8, 10) > 10 * swing(3, 5) && seen.every(([, x, y, z]) => Math.hypot(x, y, z) < 0.01);
    })()`,
  },
  net: {
    says: 'the ball is caught: it pushes the net out, goes nowhere through it, and stays in the goal',
    seconds: 5,
    each: `[...body('ball').position, Math.min(...body('net').positions.map(([, , z]) => z))]`,
    holds: `Math.min(...seen.map(([, , z]) => z)) < -0.7 && seen.every(([, , z, far]) => z > far - 0.16) &&
      Math.min(...seen.map(([, , , far]) => far)) < seen[0][3] - 0.05 && Math.abs(seen.at(-1)[0]) < 1.5 && seen.at(-1)[2] < 0.2 && seen.at(-1)[1] < 0.4`,
  },
  harbour: {
    says: 'the boat goes round the buoy on its keel, crates swim as deep as they are heavy, and no chain opens',
    seconds: 12,
    each: `[body('boat').position, ${GAP}, all('.boat, .buoy').map((one) => {
      const [, , , x, , z] = one.readPose(new Float64Array(7));
      return 1 - 2 * (x * x + z * z);
    })]`,
    holds: `(() => {
      const ways = seen.map(([[x, , z]]) => Math.atan2(x - 0.5, z - 0.1));
      const round = ways.slice(1).reduce((sum, way, i) => sum + Math.atan2(Math.sin(way - ways[i]), Math.cos(way - ways[i])), 0);
      return round > 2 * Math.PI && seen.every(([[, y]]) => Math.abs(y - 0.1) < 0.08) && Math.max(...seen.map(([, gap]) => gap)) < 0.005 &&
        seen.every(([, , ups]) => ups.length === 5 && ups.every((up) => up > 0.8)) && all('.crate').length === 6 &&
        all('.crate').every(({ position: [, y] }) => y > 0.01 && y < 0.1);
    })()`,
  },
  raft: {
    says: 'it sinks in under each crate as Archimedes says, carries a dozen and no more than it can, and begins again',
    seconds: 36,
    each: `[world.time, all('.crate').length, body('raft').position[1], Math.min(...all('.crate').map(({ position }) => position[1]))]`,
    holds: `(() => {
      // Four crates lie there, and the fifth is to come: of its logs 2.78 m³ are in the water, but for its heaving.
      const calm = seen.filter(([time]) => time > 6.3 && time < 6.95);
      const height = calm.reduce((sum, [, , y]) => sum + y / calm.length, 0);
      const wet = Math.acos(height / 0.22);
      const displaced = 7 * 3.4 * (wet - Math.sin(wet) * Math.cos(wet)) * 0.22 ** 2;
      return calm.every(([, crates]) => crates === 4) && Math.abs(displaced - 2.78) < 0.15 &&
        Number(text('most')) >= 11 && Number(text('most')) <= 17 &&
        seen.some(([time, crates]) => time > 24 && crates < 3) && seen.every(([, , , lowest]) => lowest > -1);
    })()`,
  },
  'duck-race': {
    says: 'all ducks come over the line, upright, and none leaves the river',
    seconds: 23,
    each: `all('.duck').map((duck) => {
      const [x, y, z, qx, , qz] = duck.readPose(new Float64Array(7));
      return [x, y, z, 1 - 2 * (qx * qx + qz * qz)];
    })`,
    holds: `Number(text('count')) >= 10 && all('.duck').length === 10 && all('.duck').every(({ position: [x, , z] }) => x < 1 || z < 1.6) &&
      seen.flat().every(([x, y, z, up]) => Math.abs(x) < 6 && Math.abs(z) < 3.6 && y > -0.2 && y < 0.8 && up > 0.4)`,
  },
  dominoes: {
    says: 'all of them fall',
    seconds: 26,
    holds: `all('.stone').length === 90 && all('.stone').every(({ position }) => position[1] < 0.27)`,
  },
  vase: {
    says: 'blue strikes the vase, which falls; looked back at it stands, and played on it falls to the same place',
    seconds: 3,
    holds: `(() => {
      const { timeline } = world;
      const place = () => body('vase').position.join();
      const [end, [, high], [way]] = [place(), body('vase').position, moved([body('blue')])];
      timeline.seek(timeline.from);
      const [, before] = body('vase').position;
      world.resume();
      world.advance(3 - world.time);
      return way > 0.5 && before > 1.2 && high < 0.3 && place() === end;
    })()`,
  },
  gears: {
    says: 'speeds go as the numbers of teeth, to and fro',
    seconds: 8,
    each: `[0, 1, 2].map((i) => body('gear' + i).angularVelocity[2])`,
    holds: `(([one, two, three]) => Math.abs(two / one + 10 / 20) < 0.01 && Math.abs(three / one - 10 / 14) < 0.01)(
      [0, 1, 2].map((i) => seen.slice(60).reduce((sum, rates) => sum + rates[i], 0)))`,
  },
  cradle: {
    says: 'the last ball swings out as far as the first came in, and those between stay',
    seconds: 1.4,
    each: `all('#balls x3d-rigid-body').map(({ position }, i) => position[0] - (i - 2) * 0.401)`,
    holds: `((after) => Math.max(...after.map((x) => x[4])) > 0.97 * 1.9 * Math.sin(0.7) &&
      Math.max(...after.flatMap((x) => x.slice(0, 4).map(Math.abs))) < 0.03)(seen.slice(16))`,
  },
  'wrecking-ball': {
    says: 'the ball goes through the house, and the chain holds',
    seconds: 5,
    holds: `moved(all('.block')).filter((way) => way > 0.3).length >= 20 && ${GAP} < 0.001`,
  },
  tops: {
    says: 'the wheel keeps its height and goes round in 6.2 s; tops stand',
    seconds: 6.16,
    each: `body('gyroscope').position`,
    holds: `seen.every(([, y]) => Math.abs(y - 1.25) < 0.02) && Math.min(...seen.map(([x]) => x)) < -1.78 &&
      Math.hypot(...moved([body('gyroscope')])) < 0.15 && all('#tops x3d-rigid-body').every(({ position }) => position[1] > 0.25)`,
  },
  rattleback: {
    says: 'one stone turns round, the other goes on, and the egg stands up',
    seconds: 5,
    holds: `body('red').angularVelocity[1] < -2 && Math.abs(body('blue').angularVelocity[1] + 2.5) < 0.1 &&
      body('egg').position[1] > 0.32`,
  },
  clock: {
    says: 'it ticks once a second, evenly, and each tick lets half a tooth pass',
    seconds: 24,
    each: `[world.time, body('anchor').orientation, body('wheel').orientation].map((value) =>
      Array.isArray(value) ? value[3] * Math.sign(value[2]) : value)`,
    holds: `(() => {
      const crossings = [];
      for (let i = 1; i < seen.length; i++) {
        const [[t0, a0], [t1, a1]] = [seen[i - 1], seen[i]];
        if (a0 * a1 < 0) crossings.push(t0 + ((t1 - t0) * a0) / (a0 - a1));
      }
      const ticks = crossings.slice(1).map((time, i) => time - crossings[i]).slice(8);
      const turned = seen.slice(1).reduce((sum, [, , angle], i) => {
        const way = seen[i][2] - angle;
        return sum + (way < -3 ? way + 2 * Math.PI : way);
      }, 0);
      return ticks.length >= 12 && ticks.every((tick) => Math.abs(tick - 1) < 0.05) &&
        Math.max(...ticks) - Math.min(...ticks) < 0.02 && Math.abs(turned / crossings.length - Math.PI / 30) < 0.01;
    })()`,
  },
  'marble-run': {
    says: 'marbles arrive and are counted, each time once',
    seconds: 22,
    holds: `Number(text('count')) >= 10 && Number(text('count')) <= 40`,
  },
  conveyor: {
    says: 'all that is red goes aside, all else to the end',
    seconds: 16,
    holds: `Number(text('wrong')) === 0 && Number(text('red')) >= 4 && Number(text('others')) >= 4`,
  },
  bridge: {
    says: 'carts cross it, and none falls in',
    seconds: 12,
    each: `all('.cart').map(({ position }) => position)`,
    holds: `seen.flat().every(([, y]) => y > -0.6) && seen.flat().some(([x]) => x > 5)`,
  },
  'car-on-hills': {
    says: 'it drives up the hills, on its wheels',
    seconds: 9,
    holds: `body('car').position[0] > 15 && body('car').position[1] > 0.5`,
  },
  'ragdoll-stairs': {
    says: 'it comes down, and no joint opens',
    seconds: 8,
    each: GAP,
    holds: `body('chest').position[1] < 1.5 && Math.max(...seen) < 0.005`,
  },
  crane: {
    says: 'the magnet takes a crate, and the hook lifts it',
    seconds: 13,
    first: `text('magnet'), document.getElementById('magnet').click(), document.getElementById('to-lift').value = 3.4`,
    each: `world.time > 7 ? (document.getElementById('to-lift').value = 0) : 0`,
    holds: `all('.crate').filter(({ position }) => position[1] > 2).length === 1`,
  },
  pendulum: {
    says: 'it swings to the other side, and joints open by less than 10 µm',
    seconds: 6,
    each: `[body('link7').position[0], ${GAP}]`,
    holds: `Math.min(...seen.map(([x]) => x)) < -2 && Math.max(...seen.map(([, gap]) => gap)) < 1e-5`,
  },
  rotor: {
    says: 'the rotor turns on, whatever it strikes',
    seconds: 8,
    each: `body('rotor').angularVelocity[2]`,
    holds: `Number(text('hits')) > 15 && seen.slice(40).every((rate) => rate > 0)`,
  },
  room: {
    says: 'boxes come one by one, and stay in the room',
    seconds: 9,
    holds: `all('#boxes x3d-rigid-body').length > 60 &&
      all('#boxes x3d-rigid-body').every(({ position: [x, y, z] }) => Math.abs(x) < 3 && Math.abs(z) < 3 && y > 0)`,
  },
  'growing-chain': {
    says: 'it grows by thirty links, and no hinge opens',
    seconds: 10,
    each: GAP,
    holds: `all('#chain x3d-rigid-body').length >= 30 && Math.max(...seen) < 0.001`,
  },
};
