// What views use of lit, loaded in an order that suits XHTML pages too.
import './in-xml.js';
export { html, nothing, render, svg, type TemplateResult } from 'lit/html.js';
