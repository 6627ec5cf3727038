// Who owns what: a line at the head of each build, and the licences of what is bundled, beside them.
import { readFileSync } from 'node:fs';
import license from 'rollup-plugin-license';

const FILE = 'THIRD-PARTY-LICENSES.txt';
const RULE = `\n${'-'.repeat(80)}\n\n`;

/** ammojs-typed has the licence of its own types; what it brings along is by others. */
const AMMO = readFileSync('tools/build/licenses/ammo.txt', 'utf8');

const section = ({ name, version, license: id, licenseText, noticeText }) =>
  [`${name} ${version} (${id})`, licenseText, noticeText]
    .filter(Boolean)
    .map((text) => text.trim())
    .join('\n\n');

function text(packages) {
  const unnamed = packages.filter(({ licenseText }) => !licenseText).map(({ name }) => name);
  if (unnamed.length > 0) throw new Error(`no licence text in ${unnamed.join(', ')}`);
  const sorted = packages.toSorted((a, b) => a.name.localeCompare(b.name));
  return `${['The builds of x3d-physics contain the following software.', ...sorted.map(section), AMMO.trim()].join(RULE)}\n`;
}

/** At the head of each file that people ask for: chunks are parts of these. Comes after what leaves comments out. */
export function banner() {
  const whole = license({
    sourcemap: true,
    banner: {
      commentStyle: 'ignored',
      content: '<%= pkg.name %> <%= pkg.version %> | <%= pkg.license %> licence',
    },
  });
  return {
    name: 'banner',
    renderChunk: (code, chunk, options) =>
      chunk.isEntry ? whole.renderChunk(code, chunk, options) : null,
  };
}

/** The file is that of the build which has everything in it. */
export const thirdParties = (folder) =>
  license({
    thirdParty: { output: { file: `${folder}/${FILE}`, encoding: 'utf-8', template: text } },
  });
