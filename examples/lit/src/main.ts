import './x3dom.ts';
import 'x3d-physics';
import { FallingBlocks } from './falling-blocks.ts';
import './style.css';

customElements.define('falling-blocks', FallingBlocks);
