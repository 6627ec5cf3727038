import theme from '../../styles/ui.css';
import type { X3DUIElement } from './ui-element.js';

/** Gives a view the colours and controls that all share, and its own styles. */
export const applyStyles = (host: X3DUIElement, css: string): void => host.applyStyles(theme, css);
