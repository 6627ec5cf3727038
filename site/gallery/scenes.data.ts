// What tiles of the gallery show: read from its pages when the site is built.
import { existsSync, readFileSync } from 'node:fs';
import { GALLERY } from '../.vitepress/gallery.js';

export interface Tile {
  name: string;
  title: string;
  says: string;
  /** Whether the build has a picture of it. */
  pictured: boolean;
}

declare const data: Tile[];
export { data };

const at = (path: string) => new URL(`../${path}`, import.meta.url);

const tile = ([name, title]: [string, string]): Tile => ({
  name,
  title,
  says: /^says: (.*)$/m.exec(readFileSync(at(`gallery/${name}.md`), 'utf8'))![1]!,
  pictured: existsSync(at(`public/gallery/${name}.jpg`)),
});

export default {
  watch: ['./*.md'],
  load: (): Tile[] => Object.entries(GALLERY).map(tile),
};
