// That the page opens and plays:  node browser.mjs RINGLET CHROMIUM PLAYWRIGHT
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { withReport } from './run_and_report.mjs';

const [program, executablePath, packages] = process.argv.slice(2);
const { chromium } = await import(pathToFileURL(join(packages, 'playwright-core/index.mjs')));

/** Variance of the brightness of what the canvas shows. */
function variance() {
  const canvas = document.getElementById('canvas');
  const gl = canvas.getContext('webgl2');
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let sum = 0, squares = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const brightness = pixels[i] + pixels[i + 1] + pixels[i + 2];
    sum += brightness;
    squares += brightness * brightness;
  }
  const count = width * height;
  return squares / count - (sum / count) ** 2;
}

const shownFrame = async (page) => parseInt(await page.textContent('#frame'), 10);

async function tryPage(page, report) {
  const complaints = [], requests = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(report).href);
  await page.waitForFunction(() => document.body.dataset.loaded === 'yes', null, { polling: 100 });

  assert.equal(await shownFrame(page), 1);
  // Until the first picture is there; a canvas that stays blank runs into the time limit.
  await page.waitForFunction(`(${variance})() > 100`, null, { polling: 100 });
  assert.equal(await page.locator('#plots canvas').count(), 4);
  assert.match(await page.textContent('#notes'), /16 bits/);

  // So slowly that the run does not begin anew while nobody looks.
  await page.selectOption('#rate', '0.1');
  await page.click('#play');
  await page.waitForFunction(() => parseInt(document.getElementById('frame').textContent, 10) > 3,
                             null, { polling: 100 });
  await page.keyboard.press('Space');
  assert.equal(await page.getAttribute('#play', 'aria-label'), 'play');
  await page.keyboard.press('End');
  assert.equal(await page.textContent('#frame'), '21 / 21');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await shownFrame(page), 19);

  for (const colour of ['strand', 'curvature', 'twist', 'contact', 'speed']) {
    await page.selectOption('#colour', colour);
    assert.equal(await page.isVisible('#legend'), colour !== 'strand');
  }
  assert.match(await page.textContent('#legend'), /m\/s/);
  assert.deepEqual(complaints, []);
  const elsewhere = requests.filter((url) => !/^(file|data|blob):/.test(url));
  assert.deepEqual(elsewhere, []);
}

await withReport(program, async ({ report }) => {
  const browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
           '--enable-unsafe-swiftshader'],
  });
  try {
    const page = await browser.newPage({ viewport: { width: 900, height: 600 } });
    page.setDefaultTimeout(120000);
    await tryPage(page, report);
  } finally {
    await browser.close();
  }
});
