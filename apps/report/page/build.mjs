// Bundles the page into one HTML file, with a mark where the program writes a run, as C++:
//   node build.mjs OUT.cpp
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [out] = process.argv.slice(2);

const { outputFiles } = await build({
  absWorkingDir: here,
  entryPoints: ['src/main.js'],
  outdir: join(dirname(out), 'bundle'),
  bundle: true,
  write: false,
  minify: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'inline',
  charset: 'utf8',
});
const text = (ending) => outputFiles.find((file) => file.path.endsWith(ending)).text;

// Functions, since a $ in a replacement would mean something; </ would end the element.
const page = readFileSync(join(here, 'index.html'), 'utf8')
  .replace('/*STYLE*/', () => text('.css'))
  .replace('/*SCRIPT*/', () => text('.js').replaceAll('</script', '<\\/script'));

/** In pieces, since compilers need not take longer literals; never within a character. */
function literals(whole, length = 8000) {
  const characters = [...whole];
  const pieces = [];
  for (let at = 0; at < characters.length; at += length) {
    pieces.push(`      R"page(${characters.slice(at, at + length).join('')})page",`);
  }
  return pieces.join('\n');
}

writeFileSync(out, `// Written by build.mjs.
#include "apps/report/page.h"

namespace ringlet {

std::string page_template() {
  std::string page;
  for (const char* piece : {
${literals(page)}
       }) {
    page += piece;
  }
  return page;
}

}  // namespace ringlet
`);
