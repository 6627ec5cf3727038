// A command for browser tests, beside those for mouse and keys that Web Test Runner brings: fingers on the screen.

/** DevTools sessions by page. */
const sessions = new WeakMap();

async function byPlaywright(page, { type, points }) {
  if (!sessions.has(page)) sessions.set(page, await page.context().newCDPSession(page));
  const touchPoints = points.map(({ x, y, id = 0 }) => ({ x, y, id }));
  const name = { start: 'touchStart', move: 'touchMove', end: 'touchEnd', cancel: 'touchCancel' };
  await sessions.get(page).send('Input.dispatchTouchEvent', { type: name[type], touchPoints });
}

async function byPuppeteer(page, { type, points: [point] }) {
  if (type === 'start') await page.touchscreen.touchStart(point.x, point.y);
  else if (type === 'move') await page.touchscreen.touchMove(point.x, point.y);
  else await page.touchscreen.touchEnd();
}

function byWebDriver(browser, id, { type, points: [point] }) {
  const to = { type: 'pointerMove', duration: 0, ...point };
  const actions = {
    start: [to, { type: 'pointerDown', button: 0 }],
    move: [to],
    end: [{ type: 'pointerUp', button: 0 }],
  };
  const finger = { type: 'pointer', id: 'touch1', parameters: { pointerType: 'touch' } };
  return browser.driverManager.performActions(id, [{ ...finger, actions: actions[type] }]);
}

/** `sendTouch`: `points` are those that are down, once the last one ends none. Only Chromium takes several, or a cancel. */
export const touchPlugin = () => ({
  name: 'send-touch',
  async executeCommand({ command, payload, session }) {
    if (command !== 'send-touch') return undefined;
    const { browser, id } = session;
    if (browser.type === 'playwright') await byPlaywright(browser.getPage(id), payload);
    else if (browser.type === 'puppeteer') await byPuppeteer(browser.getPage(id), payload);
    else await byWebDriver(browser, id, payload);
    return true;
  },
});
