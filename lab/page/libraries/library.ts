import type { PageScene, Thing } from '../scene.js';

/** A library that the scenes are shown by. */
export interface Library {
  /** As numbers, charts and pages name it. */
  id: string;
  name: string;
  /** What it does in a frame, and by what. */
  says: string;
  /** Of its page. */
  type: string;
  page(scene: PageScene, address: string): string;
  /** A file beside the page, where it has one. */
  file?(scene: PageScene): string;
}

/** Pixels of each canvas: the same for all, and small, since it is drawn without a graphics card. */
export const SIZE = { width: 240, height: 180 };

/** First of all scripts: frames and the clock are ours. */
export const HOOKS = (library: string): string =>
  `<script src="/hooks.js" data-library="${library}"></script>`;

export const STYLE = `<style>html,body{margin:0;overflow:hidden}</style>`;

export const isDrawn = ({ mass }: Thing): boolean => mass > 0;

export const text = (numbers: readonly number[]): string =>
  numbers.map((number) => Number(number.toFixed(6))).join(' ');
