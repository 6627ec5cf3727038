// A command of Web Test Runner that speaks the DevTools protocol to the page of the test, as the Elements panel does.

/** The page's connection, made at its first command. */
const connections = new WeakMap();

async function connectionTo(page) {
  if (!connections.has(page)) connections.set(page, await page.context().newCDPSession(page));
  return connections.get(page);
}

/** Of Chromium by Playwright: `executeServerCommand('devtools', { method, params })`. */
export const devtoolsCommand = () => ({
  name: 'devtools-command',
  async executeCommand({ command, payload, session }) {
    if (command !== 'devtools') return undefined;
    const connection = await connectionTo(session.browser.getPage(session.id));
    return (await connection.send(payload.method, payload.params)) ?? {};
  },
});
