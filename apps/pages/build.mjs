// Bundles a page into one HTML file, with a mark where the program writes its data, as the C++
// function NAME_page_template():
//   node build.mjs NAME SOURCES OUT.cpp
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [name, sources, out] = process.argv.slice(2);

const { outputFiles } = await build({
  entryPoints: [join(sources, 'src/main.js')],
  outdir: 'bundle',
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
const page = readFileSync(join(sources, 'index.html'), 'utf8')
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
#include "apps/pages/page_templates.h"

namespace ringlet {

std::string ${name}_page_template() {
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
