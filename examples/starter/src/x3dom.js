// x3dom is a classic script, and sets its global only as one: it comes by a tag of its own.
import address from 'x3dom/x3dom.js?url';

document.head.append(Object.assign(document.createElement('script'), { src: address }));
