import { Cloud, PARTICLE } from './cloud.js';

/** What somebody sees of a system at a moment. */
export interface Seen {
  cloud: Cloud;
  /** The first of its cloud that is there. */
  first: number;
  /** Seconds that its system has lived. */
  time: number;
}

/** A moment of a system that is kept to be looked at, not to go on from: in single precision. */
export interface CloudPicture {
  motion: Float32Array;
  /** Of each, seconds. */
  ages: Float32Array;
}

export function pictureOf({ cloud, first, time }: Seen): CloudPicture {
  const born = cloud.born.subarray(first, cloud.count);
  return {
    motion: Float32Array.from(cloud.motion.subarray(first * PARTICLE, cloud.count * PARTICLE)),
    ages: Float32Array.from(born, (birth) => time - birth),
  };
}

/** As if its system began at that moment. */
export function seenIn({ motion, ages }: CloudPicture): Seen {
  const cloud = new Cloud();
  cloud.show(
    motion,
    ages.map((age) => -age),
  );
  return { cloud, first: 0, time: 0 };
}
