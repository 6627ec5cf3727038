/** What most fields are. Their tables say it all the same; builds for pages leave it out there (tools/build/rollup-plugins.js). */
export const USUAL = { access: 'inputOutput', edit: 'live' };
