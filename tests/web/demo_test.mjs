// The page of the npm package in Chromium, from a folder, as a person uses it. Skipped where what docs/web.md installs by npm, or
// Chromium, is not there. WEB_PACKAGE names the package's folder.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const web = resolve(process.env.WEB_PACKAGE, '..');
const chromium = '/usr/bin/chromium';
const missing = ['three', 'esbuild', 'playwright-core', 'lineatlas'].filter((name) => !existsSync(join(web, 'node_modules', name)));
const skip = missing.length > 0 ? `there is no ${missing.join(', ')} (docs/web.md)` : existsSync(chromium) ? false : `there is no ${chromium}`;
let browser, page, faults;

before(async () => {
  if (skip) return;
  execFileSync(process.execPath, [fileURLToPath(new URL('../../web/demo/build.mjs', import.meta.url)), web]);
  const playwright = createRequire(join(web, 'package.json'))('playwright-core');
  browser = await playwright.chromium.launch({
    executablePath: chromium,
    args: ['--no-sandbox', '--headless=new', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
});
after(() => browser?.close());

async function open() {
  await page?.close();
  page = await browser.newPage({ viewport: { width: 900, height: 700 }, acceptDownloads: true });
  faults = [];
  page.on('pageerror', (error) => faults.push(error.message));
  await page.goto(pathToFileURL(join(web, 'demo/index.html')).href);
  return exactPieces();
}
const state = () => page.textContent('#state');
async function exactPieces() {
  await page.waitForFunction(() => /pieces, exact/.test(document.getElementById('state').textContent), null, { timeout: 60000 });
  return Number((await state()).replace(/ pieces.*/, '').replaceAll(',', ''));
}
/// What the page says once it has drawn anew after `action`.
async function piecesAfter(action) {
  await page.evaluate(() => { document.getElementById('state').textContent = 'waiting'; });
  await action();
  return exactPieces();
}
async function saved(button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  return readFileSync(await download.path(), 'utf8');
}
const cube = `${[0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => `v ${x} ${y} ${z}`))).join('\n')}
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n`;
const fileOf = (name, text) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

test('a model of ones own is drawn, hidden lines appear, and both files are saved', { skip }, async () => {
  await open();
  assert.equal(await piecesAfter(() => page.setInputFiles('#file', fileOf('cube.obj', cube))), 9);
  assert.equal(await piecesAfter(() => page.check('#hidden')), 12);
  const svg = await saved('#svg');
  assert.match(svg, /class="crease hidden"/);
  assert.equal(svg.match(/<svg [^>]*>/)[0].match(/viewBox="0 0 (\d+) (\d+)"/).slice(1).join('x'), '612x700');
  assert.match(await saved('#dxf'), /AC1018[\s\S]*EOF/);
  assert.deepEqual(faults, []);
});

test('a file is read as by the package: parts, lines, and what is wrong with it', { skip }, async () => {
  await open();
  assert.ok((await piecesAfter(() => page.setInputFiles('#file', fileOf('two.obj', `o left\n${cube}l 2 9\nv 2 2 2\n`)))) > 9);
  assert.deepEqual(await page.locator('#parts label').allTextContents(), [' left']);
  await page.setInputFiles('#file', fileOf('short.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n'));
  await page.waitForFunction(() => document.getElementById('state').classList.contains('error'));
  assert.equal(await state(), 'cannot read "short.obj": line 4 refers to vertex 9, the file has 3');
  assert.deepEqual(faults, []);
});

test('a part that is hidden uncovers what is behind it', { skip }, async () => {
  const whole = await open();
  const rest = await piecesAfter(() => page.uncheck('#parts label:last-child input'));
  assert.notEqual(rest, whole);
  assert.equal(await piecesAfter(() => page.check('#parts label:last-child input')), whole);
  assert.deepEqual(faults, []);
});

test('a turn and a parallel view are drawn anew, a cut is hatched', { skip }, async () => {
  await open();
  await page.evaluate(() => {
    window.said = [];
    new MutationObserver(() => window.said.push(document.getElementById('state').textContent))
      .observe(document.getElementById('state'), { childList: true });
  });
  const turned = await piecesAfter(async () => {
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.move(400, 330, { steps: 4 });
    await page.mouse.up();
  });
  assert.ok(turned > 0);
  assert.ok((await page.evaluate(() => window.said)).some((text) => text.startsWith('Roughly')));
  assert.ok((await piecesAfter(() => page.check('#parallel'))) > 0);
  await piecesAfter(() => page.selectOption('#axis', '2'));
  assert.match(await saved('#svg'), /class="hatching visible"/);
  assert.deepEqual(faults, []);
});

test('a file that is none is refused in one line', { skip }, async () => {
  await open();
  await page.setInputFiles('#file', fileOf('model.xyz', 'x'));
  await page.waitForFunction(() => document.getElementById('state').classList.contains('error'));
  assert.equal(await state(), 'model.xyz is none of obj, ply, stl, off, glb, gltf');
  assert.deepEqual(faults, []);
});
