// Tiles that lead to the gallery's scenes: all of them, or the first `count`.
import { h } from 'vue';
import { withBase } from 'vitepress';
import { data, type Tile } from '../../gallery/scenes.data.js';

const picture = ({ name, pictured }: Tile) =>
  pictured
    ? h('img', {
        src: withBase(`/gallery/${name}.jpg`),
        width: 640,
        height: 400,
        loading: 'lazy',
        alt: '',
      })
    : h('span', { class: 'plain' });

const tile = (shown: Tile) =>
  h('li', [
    h('a', { href: withBase(`/gallery/${shown.name}`) }, [
      picture(shown),
      h('strong', shown.title),
      h('span', shown.says),
    ]),
  ]);

export const galleryTiles = ({ count }: { count?: number | string }) =>
  h('ul', { class: 'tiles' }, data.slice(0, count ? Number(count) : undefined).map(tile));
galleryTiles.props = ['count'];
