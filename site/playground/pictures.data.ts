// Pictures of scenes that the site is built with, for the menu: their addresses from where the site lies.
import { existsSync, readdirSync } from 'node:fs';

const PUBLIC = new URL('../public/', import.meta.url);
const FOLDERS = ['gallery', 'scenes/pictures'];

declare const data: string[];
export { data };

export default {
  load: (): string[] =>
    FOLDERS.filter((folder) => existsSync(new URL(folder, PUBLIC))).flatMap((folder) =>
      readdirSync(new URL(folder, PUBLIC)).map((name) => `${folder}/${name}`),
    ),
};
