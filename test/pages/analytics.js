// A script of a page that has nothing to do with physics.
globalThis.analytics = true;
