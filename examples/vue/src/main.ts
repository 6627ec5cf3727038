import './x3dom.ts';
import 'x3d-physics';
import 'x3d-physics/vue';
import { createApp } from 'vue';
import App from './App.vue';
import './style.css';

createApp(App).mount('#app');
