// The visitor's own font: one that comes later moves all lines, and weighs as much as the library's core and contacts.
import DefaultTheme from 'vitepress/theme-without-fonts';
import { h, type App } from 'vue';
import { withBase } from 'vitepress';
import { galleryTiles } from './tiles.js';
import './site.css';

const notFound = () =>
  h('main', { class: 'not-found' }, [
    h('h1', 'There is no such page'),
    h('p', h('a', { href: withBase('/') }, 'To the first page')),
  ]);

export default {
  extends: DefaultTheme,
  Layout: () => h(DefaultTheme.Layout, null, { 'not-found': notFound }),
  enhanceApp: ({ app }: { app: App }) => void app.component('GalleryTiles', galleryTiles),
};
