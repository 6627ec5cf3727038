import { existsSync, readdirSync } from 'node:fs';
import { defineConfig, type DefaultTheme } from 'vitepress';
import { charts } from '../markdown/charts.js';
import { liveExamples } from '../markdown/fence.js';
import { storiesBeside } from '../markdown/stories.js';
import { emptyHeads, proseTables } from '../markdown/tables.js';
import { sidebar } from './sidebar.js';

/** Another one where the site does not lie at its server's root: `SITE_BASE=/x3d-physics/`. */
const base = process.env.SITE_BASE ?? '/';

const here = (path: string) => new URL(`../${path}`, import.meta.url);

/** The playground is a page of the site from the moment it is there. */
const hasPlayground = existsSync(here('playground/index.ts'));

const nodes = readdirSync(here('generated'), { recursive: true })
  .map((file) => String(file).replaceAll('\\', '/'))
  .filter((file) => file.startsWith('reference/'))
  .map((file) => file.slice('reference/'.length, -'.md'.length));

const nav: DefaultTheme.NavItem[] = [
  { text: 'Guide', link: '/guide/which-file', activeMatch: '/guide/' },
  { text: 'Recipes', link: '/recipes/door', activeMatch: '/recipes/' },
  { text: 'Gallery', link: '/gallery/', activeMatch: '/gallery/' },
  { text: 'Reference', link: '/reference/RigidBody', activeMatch: '/reference/' },
  ...(hasPlayground ? [{ text: 'Playground', link: '/playground' }] : []),
  { text: 'Stories', link: '/stories/index.html', target: '_self' },
];

export default defineConfig({
  base,
  lang: 'en',
  title: 'x3d-physics',
  description: 'The rigid body physics of the X3D standard for X3DOM, as custom elements',
  outDir: '../site-static',
  srcExclude: ['public/**', 'playground/**', ...(hasPlayground ? [] : ['playground.md'])],
  rewrites: { 'generated/:path(.*)': ':path' },
  // The stories are built after the site, into its folder.
  ignoreDeadLinks: [/^\/stories\//],
  head: [
    ['link', { rel: 'icon', href: `${base}logo.svg` }],
    // For the playground and for page code: the package's names, as a page would have them.
    [
      'script',
      { type: 'importmap' },
      JSON.stringify({
        imports: {
          'x3d-physics': `${base}x3d-physics/x3d-physics.js`,
          'x3d-physics/core': `${base}x3d-physics/core.js`,
        },
      }),
    ],
  ],
  // The scene is what these pages are for: it gets all the room.
  transformPageData({ relativePath, frontmatter }) {
    if (!relativePath.startsWith('gallery/')) return;
    Object.assign(frontmatter, { aside: false, pageClass: 'gallery' });
  },
  vite: { plugins: [storiesBeside(base)] },
  // VitePress itself says so only when its script runs, and the bar would move then.
  transformHtml: (html) =>
    html.includes('VPNavBarTitle has-sidebar')
      ? html.replace('class="VPNavBar"', 'class="VPNavBar has-sidebar"')
      : html,
  markdown: {
    // The contrast that small text needs.
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    config: (md) => md.use(liveExamples, base).use(charts, base).use(emptyHeads).use(proseTables),
  },
  themeConfig: {
    logo: { src: '/logo.svg', width: 24, height: 24, alt: '' },
    nav,
    sidebar: sidebar(nodes),
    outline: [2, 3],
    search: { provider: 'local' },
  },
});
