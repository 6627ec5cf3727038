// A script of a text runs in a sandbox; nothing but a script is to run, nor bring in what runs: the usual attacks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { clean } from '../../../site/playground/text/left-out.js';
import { parse } from '../../../site/playground/text/parse.js';
import { print } from '../../../site/playground/text/print.js';

const TAGS = new Set(
  'transform shape box appearance imagetexture inline anchor x3d-rigid-body script'.split(' '),
);

function cleaned(text: string) {
  const { roots, fault } = parse(text);
  if (!roots) return { printed: '', messages: [fault.message] };
  const { roots: kept, leftOut } = clean(roots, TAGS);
  return { printed: print(kept), messages: leftOut.map(({ message }) => message) };
}

const ATTACKS = [
  '<scene><Script url="ecmascript: alert(1)"/></scene>',
  '<transform onclick="alert(1)"></transform>',
  '<transform ONMOUSEOVER=alert(1)></transform>',
  '<x3d ondownloadsfinished="alert(1)"></x3d>',
  '<transform xml:onclick="alert(1)"></transform>',
  '<img src=x onerror=alert(1)>',
  '<svg onload=alert(1)></svg>',
  '<svg><script>alert(1)</script></svg>',
  '<math><mtext><table><mglyph><style><img src=x onerror=alert(1)></style></mglyph></table></mtext></math>',
  '<iframe src="javascript:alert(1)"></iframe>',
  '<iframe srcdoc="<script>alert(1)</script>"></iframe>',
  '<object data="javascript:alert(1)"></object>',
  '<embed src="data:text/html,<script>alert(1)</script>">',
  '<link rel="stylesheet" href="https://evil.example/x.css">',
  '<meta http-equiv="refresh" content="0;url=javascript:alert(1)">',
  '<base href="https://evil.example/">',
  '<form action="javascript:alert(1)"><button>x</button></form>',
  '<a href="javascript:alert(1)">x</a>',
  '<a href="JaVaScRiPt:alert(1)">x</a>',
  '<a href=" &#1; javascript:alert(1)">x</a>',
  '<a href="java&#10;script:alert(1)">x</a>',
  '<a href="&#106;avascript&#58;alert(1)">x</a>',
  '<a href="data:text/html,x">x</a>',
  `<anchor url='"javascript:alert(1)"'></anchor>`,
  `<anchor url='"a.html" "javascript:alert(1)"'></anchor>`,
  '<inline url="data:model/x3d+xml,x"></inline>',
  '<inline url="file:///etc/passwd"></inline>',
  '<imagetexture url="blob:https://site/1"></imagetexture>',
  '<imagetexture url="vbscript:x"></imagetexture>',
  '<field name="url" value="javascript:alert(1)"></field>',
  '<noscript><p title="</noscript><img src=x onerror=alert(1)>"></p></noscript>',
  '<a xlink:href="javascript:alert(1)">x</a>',
  '<custom-thing></custom-thing>',
  '<portal src="https://evil.example"></portal>',
];

/** What would run, or bring something in: a tag or attribute that only the attack needs. */
const RUNS =
  /<(script|img|svg|math|iframe|object|embed|link|meta|base|form|noscript|custom|portal)|\son\w+=|:on\w+=|script&?:|script:|data:|blob:|file:|srcdoc/i;

for (const attack of ATTACKS) {
  test(`nothing runs of ${attack}`, () => {
    assert.doesNotMatch(cleaned(attack).printed, RUNS);
  });
}

test('what is left out is told', () => {
  assert.deepEqual(cleaned('<transform onclick="x"><blink></blink></transform>').messages, [
    '<transform>: onclick is left out in the playground: listen by addEventListener in a <script>.',
    '<blink> is no tag that the playground knows: left out with all that stands in it.',
  ]);
});

test('addresses of http, https and of the same site stay', () => {
  for (const url of [
    'https://a.example/b.png',
    'http://a.example/b.png',
    '../b.png',
    'b.x3d#c',
    '"a.png" "b.png"',
    'data:image/png;base64,iVBORw0KGgo=',
    'data:model/gltf-binary;base64,Z2xURgIAAAA=',
  ]) {
    const { messages } = cleaned(`<inline url='${url}'></inline>`);
    assert.deepEqual(messages, []);
  }
});

test('geometry that the library draws where x3dom has none stays', () => {
  const scene = '<shape><elevationgrid xdimension="2" zdimension="2"></elevationgrid></shape>';
  assert.deepEqual(cleaned(scene).messages, []);
});

test('scripts and styles stay, but for those that every page has', () => {
  const own = '<script type="module">\n  run();\n</script>\n<style>p { color: red }</style>';
  const ofPage = [
    '<script src="../node_modules/x3dom/x3dom.js"></script>',
    '<script type="module" src="https://a.example/x3d-physics.js"></script>',
    '<script type="importmap">{ "imports": {} }</script>',
  ];
  const { printed, messages } = cleaned([...ofPage, own].join('\n'));
  assert.equal(printed, own);
  assert.deepEqual(messages, []);
});

test('the page around a scene is no part of it', () => {
  const page =
    '<!doctype html><html><head><title>x</title></head><body><p>Hello</p><box></box></body></html>';
  assert.equal(cleaned(page).printed, '<p>\n  Hello\n</p>\n<box></box>');
});
