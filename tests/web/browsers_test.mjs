// The npm package in Chromium and Firefox: the SVG of ten models has the hash of the library's. A page does it, and posts what it
// found. A browser that is not there is skipped. WEB_PACKAGE names the package's folder, WEB_DRAWINGS what native_drawings wrote.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { models } from './models.mjs';

const { WEB_PACKAGE, WEB_DRAWINGS } = process.env;
const browsers = {
  chromium: (profile, url) => ['--headless=new', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`, url],
  'firefox-esr': (profile, url) => ['--headless', '--no-remote', '--profile', profile, url],
};

/// Runs in the page.
async function drawAll(models) {
  const hashes = {};
  try {
    const { Lines, init } = await import('/package/lineatlas.js');
    await init();
    for (const name of models) {
      const { positions, indices, materials, segments, ...camera } = await (await fetch(`/drawings/${name}.json`)).json();
      const mesh = { positions: Float32Array.from(positions), indices: Uint32Array.from(indices), name: 'model' };
      if (materials.length > 0) mesh.materials = Uint32Array.from(materials);
      const lines = new Lines(mesh), drawing = lines.draw(camera);
      const hash = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(drawing.toSVG()));
      hashes[name] = [...new Uint8Array(hash)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
      for (const one of [drawing, lines]) one.dispose();
    }
  } catch (error) {
    hashes.error = error.message;
  }
  await fetch('/found', { method: 'POST', body: JSON.stringify(hashes) });
}

const page = `<!DOCTYPE html><title>lineatlas</title><script type="module">${drawAll}\ndrawAll(${JSON.stringify(models)})</script>`;
const types = { js: 'text/javascript', wasm: 'application/wasm', json: 'application/json' };

/// Serves page, package and models, and calls `found` with what the page posts.
function serve(found) {
  const folders = { package: WEB_PACKAGE, drawings: WEB_DRAWINGS };
  const server = createServer((request, response) => {
    const [, folder, name] = request.url.split('/');
    if (request.method === 'POST') {
      let body = '';
      request.on('data', (data) => { body += data; });
      request.on('end', () => { response.end(); found(JSON.parse(body)); });
    } else if (request.url === '/') {
      response.setHeader('Content-Type', 'text/html').end(page);
    } else if (folders[folder] && existsSync(join(folders[folder], name))) {
      response.setHeader('Content-Type', types[name.split('.').pop()]).end(readFileSync(join(folders[folder], name)));
    } else {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => { server.listen(0, '127.0.0.1', () => resolve(server)); });
}

async function hashesIn(browser) {
  const profile = mkdtempSync(join(tmpdir(), 'lineatlas-'));
  let server, child;
  try {
    return await new Promise((resolve, reject) => {
      serve(resolve).then((made) => {
        server = made;
        child = spawn(`/usr/bin/${browser}`, browsers[browser](profile, `http://127.0.0.1:${server.address().port}/`),
          { stdio: 'ignore', detached: true, env: { ...process.env, HOME: profile } });
        child.on('error', reject);
        child.on('exit', (code) => reject(new Error(`${browser} ended with ${code} before its page was done`)));
      });
    });
  } finally {
    server?.close();
    if (child?.pid) process.kill(-child.pid, 'SIGKILL'); // with the processes that it started
    await new Promise((resolve) => { child?.exitCode === null && child.signalCode === null ? child.once('close', resolve) : resolve(); });
    rmSync(profile, { recursive: true, force: true, maxRetries: 10 });
  }
}

for (const browser of Object.keys(browsers)) {
  const skip = existsSync(`/usr/bin/${browser}`) ? false : `there is no ${browser} (on Debian: apt install ${browser})`;
  test(`${browser} draws what the library draws`, { skip }, async () => {
    const hashOf = (name) => createHash('sha256').update(readFileSync(join(WEB_DRAWINGS, `${name}.svg`))).digest('hex');
    assert.deepEqual(await hashesIn(browser), Object.fromEntries(models.map((name) => [name, hashOf(name)])));
  });
}
