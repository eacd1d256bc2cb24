// Builds the page into one script beside index.html. The script contains the module, so the page also works without a server.
// Usage: build.mjs WEB. WEB is the folder with `package` and `node_modules`. Writes WEB/demo.
import { copyFile, mkdir } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url)), web = resolve(process.argv[2]);
const { build } = createRequire(join(web, 'package.json'))('esbuild');
const common = { bundle: true, minify: true, format: 'iife', nodePaths: [join(web, 'node_modules')], external: ['node:*'], logOverride: { 'empty-import-meta': 'silent' } };

const worker = await build({ ...common, entryPoints: [join(web, 'package/worker_thread.js')], write: false });

const inside = {
  name: 'inside',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^inside:/ }, ({ path }) => ({ path, namespace: 'inside' }));
    onLoad({ filter: /worker$/, namespace: 'inside' }, () => ({ contents: worker.outputFiles[0].text, loader: 'text' }));
  },
};
await mkdir(join(web, 'demo'), { recursive: true });
await build({ ...common, entryPoints: [join(here, 'demo.mjs')], outfile: join(web, 'demo/demo.js'), plugins: [inside], loader: { '.wasm': 'binary' } });
await copyFile(join(here, 'index.html'), join(web, 'demo/index.html'));
