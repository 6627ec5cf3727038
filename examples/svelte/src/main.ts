import './x3dom.ts';
import 'x3d-physics';
import 'x3d-physics/svelte';
import { mount } from 'svelte';
import App from './App.svelte';
import './style.css';

mount(App, { target: document.getElementById('app')! });
