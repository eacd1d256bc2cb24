// Prints the sizes of the npm package's files that a page loads, as they are and compressed as by servers. Usage: web_size.mjs PACKAGE
import { readFileSync } from 'node:fs';
import { brotliCompressSync, gzipSync } from 'node:zlib';

const [folder] = process.argv.slice(2);
for (const name of ['lineatlas.js', 'lineatlas.wasm']) {
  const bytes = readFileSync(`${folder}/${name}`);
  const sizes = [bytes, gzipSync(bytes, { level: 9 }), brotliCompressSync(bytes)].map(({ length }) => `${(length / 1000).toFixed(1)} kB`);
  console.log(`${folder}/${name}: ${sizes[0]}, gzip ${sizes[1]}, brotli ${sizes[2]}`);
}
