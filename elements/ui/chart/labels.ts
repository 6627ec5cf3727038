/** Where a name is written: the start or the end of its base line, pixels. */
export interface Label {
  text: string;
  x: number;
  y: number;
  anchor: 'start' | 'end';
}

interface Place {
  name: string;
  x: number;
  y: number;
}

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Pixels: of a line, and of a dot's half. */
const LINE = 14;
const DOT = 8;

/** Of a name, pixels: 8 for a letter, as broad fonts have it that are bold. */
const widthOf = (text: string): number => 8 * text.length;

/** Pixels on either side of a name, for its halo: 1.5, of which Firefox makes 2.5 where it says how wide a name is. */
const BESIDE = 4;

/** From a dot's middle to the base line of its name: above it, below it, and farther, at last anywhere, where dots are close. */
const LINES = [-6, 16, -20, 30, -34, 44];
for (let more = 4; more < 96; more += 4) LINES.push(-34 - more, 44 + more);

const boxOf = ({ text, x, y, anchor }: Label): Box => {
  const left = anchor === 'start' ? x : x - widthOf(text);
  const right = left + widthOf(text);
  return { left: left - BESIDE, right: right + BESIDE, top: y - LINE + 3, bottom: y + 3 };
};

const boxAround = ({ x, y }: Place): Box => ({
  left: x - DOT,
  right: x + DOT,
  top: y - DOT,
  bottom: y + DOT,
});

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const beside = ({ name, x, y }: Place, anchor: Label['anchor'], down: number): Label => ({
  text: name,
  x: anchor === 'start' ? x + DOT + 1 : x - DOT - 1,
  y: y + down,
  anchor,
});

/**
 * Names beside their dots, where they hide neither each other nor another dot; to the right and above where there is
 * room. In a crowd a name rather lies on a dot than on another name.
 */
export function labelsOf(dots: readonly Place[], within: Box): Label[] {
  const labels: Label[] = [];
  for (const dot of dots) {
    const names = labels.map(boxOf);
    const others = dots.filter((other) => other !== dot).map(boxAround);
    const free = (boxes: readonly Box[]) => (label: Label) =>
      !boxes.some((box) => overlap(boxOf(label), box));
    const around = LINES.flatMap((down) => [
      beside(dot, 'start', down),
      beside(dot, 'end', down),
    ]).filter((label) => {
      const { left, right, top, bottom } = boxOf(label);
      const inside = left >= within.left && right <= within.right && bottom <= within.bottom;
      // Above the grid there is room as well.
      return inside && top >= 0;
    });
    labels.push(
      around.find(free([...names, ...others])) ??
        around.find(free(names)) ??
        beside(dot, 'start', LINES[0]!),
    );
  }
  return labels;
}
