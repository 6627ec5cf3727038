import './x3dom.ts';
import 'x3d-physics';
import 'x3d-physics/solid';
import { render } from 'solid-js/web';
import { App } from './App.tsx';
import './style.css';

render(() => <App />, document.getElementById('app')!);
