// The ES module of the package: registers all elements with the page and with x3dom.
import { begin } from './begin.js';

begin();

export * from './api.js';
