// In an XML document innerHTML takes XML, which lit's templates are not: there they are parsed in an HTML document.
// lit has one hook for who prepares its templates, read when it is loaded; import this before lit.

interface TemplateClass {
  createElement(html: string): HTMLTemplateElement;
}
const hooks = globalThis as { litHtmlPolyfillSupport?: (template: TemplateClass) => void };

if (document.contentType !== 'text/html') {
  const inert = document.implementation.createHTMLDocument('');
  hooks.litHtmlPolyfillSupport ??= (template) => {
    template.createElement = (html) => {
      const element = inert.createElement('template');
      element.innerHTML = html;
      return element;
    };
  };
}
