/** Whether it was written where the parser knows no self-closing tags; what is made from JSON was not. */
export const isHTML = (element: Element): boolean =>
  element.ownerDocument.contentType === 'text/html' &&
  element.namespaceURI === 'http://www.w3.org/1999/xhtml';
