/** What a block is made of; where it is knows the world alone. */
export interface Block {
  id: number;
  color: string;
  mass: number;
  hits: number;
}

const COLORS = ['0.9 0.4 0.2', '0.25 0.55 0.85', '0.3 0.7 0.4', '0.85 0.7 0.2', '0.6 0.4 0.8'];

export const newBlock = (id: number): Block => ({
  id,
  color: COLORS[id % COLORS.length]!,
  mass: 1,
  hits: 0,
});

/** Where it starts: side by side, so that each falls upon the floor. */
export const startOf = ({ id }: Block): string => `${((id * 3) % 11) - 5} ${4 + (id % 3)} 0`;

/** X3D's colours are numbers from 0 to 1. */
export const css = (color: string): string =>
  `rgb(${color
    .split(' ')
    .map((part) => Number(part) * 255)
    .join(' ')})`;
