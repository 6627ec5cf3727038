// Pictures of scenes that the site is built with, for the menu: their addresses from where the site lies.
import { existsSync, readdirSync } from 'node:fs';

const FOLDER = new URL('../public/gallery', import.meta.url);

declare const data: string[];
export { data };

export default {
  load: (): string[] =>
    existsSync(FOLDER) ? readdirSync(FOLDER).map((name) => `gallery/${name}`) : [],
};
