import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vite';

/** The tags of a scene are no components: ours have a hyphen, x3dom's are unknown to HTML. */
const SCENE =
  /^(x3d(-.+)?|scene|viewpoint|navigationinfo|directionallight|background|transform|shape|appearance|material|box|sphere)$/;

export default defineConfig({
  plugins: [vue({ template: { compilerOptions: { isCustomElement: (tag) => SCENE.test(tag) } } })],
});
