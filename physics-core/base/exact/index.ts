// Functions that come to the same bits wherever they run. Those of `Math` are as each browser has them: sines, arcs and
// exponentials differ in their last bit between Node, Chromium and Firefox, lengths between all but Chromium and Node.
// These are fdlibm's, by whole sums, products and roots alone, which IEEE 754 rounds everywhere alike; Node 20 has the same.
//
// fdlibm: Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunPro, a Sun Microsystems, Inc.
// business. Permission to use, copy, modify, and distribute this software is freely granted, provided that this notice is
// preserved.
//
// Those that worlds without joints and particles have no use for, asin.ts and expm1.ts, are imported by themselves.
export { atan2 } from './arcs.js';
export { exp, log } from './exponentials.js';
export { hypot, lengthOf } from './hypot.js';
export { cos, sin } from './sin-cos.js';
