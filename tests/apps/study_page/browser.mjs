// That the page of a study opens and answers:  node browser.mjs WRITE_STUDY_PAGE CHROMIUM PLAYWRIGHT
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { hostileName, makeResults, ofManyVariants, withoutReference } from './results.mjs';

const [program, executablePath, packages] = process.argv.slice(2);
const { chromium } = await import(pathToFileURL(join(packages, 'playwright-core/index.mjs')));

/** Exit code of a test that CTest then counts as skipped. */
const skipped = 77;

function writePage(place, results) {
  const [from, to] = [join(place, 'results.json'), join(place, 'study.html')];
  writeFileSync(from, JSON.stringify(results));
  const { status, stderr } = spawnSync(program, [from, to], { encoding: 'utf8' });
  if (stderr.includes('built without the page')) {
    console.log(stderr);
    process.exit(skipped);
  }
  assert.equal(status, 0, stderr);
  return pathToFileURL(to).href;
}

/** Calls a test with the page of some results; it may neither complain nor ask for anything. */
async function withPage(browser, results, test) {
  const place = mkdtempSync(join(tmpdir(), 'ringlet_study_'));
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(60000);
  const complaints = [], requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  try {
    await page.goto(writePage(place, results));
    await page.waitForFunction(() => document.body.dataset.loaded === 'yes', null, { polling: 100 });
    await test(page);
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests.filter((url) => !/^(file|data):/.test(url)), []);
  } finally {
    await page.close();
    rmSync(place, { recursive: true });
  }
}

const texts = (page, selector) => page.locator(selector).allTextContents();
const places = (page) => page.locator('.point').evaluateAll(
  (points) => points.map((point) => point.getAttribute('transform')));

/** Number of all variants, and of those with a time. */
async function showsAll(page, results) {
  const rows = await texts(page, '#table tbody th');
  assert.deepEqual(new Set(rows.map((name) => name.replace(/ \(default\)$/, ''))),
                   new Set(results.variants.map(({ name }) => name)));
  assert.equal(rows.length, results.variants.length);
  const timed = results.variants.filter(({ seconds }) => seconds !== null);
  assert.equal(await page.locator('.point').count(), timed.length);
}

async function tryPlot(page, results) {
  const first = await places(page);
  assert.ok(first.every((place) => /^translate\([\d.]+ [\d.]+\)$/.test(place)), first.join());
  assert.ok(new Set(first).size > 20);
  assert.ok((await texts(page, '.label')).some((text) => text.includes('(default)')));
  assert.equal(await page.locator('.front').count(), 1);
  const boxes = await page.locator('.label').evaluateAll(
    (labels) => labels.map((label) => label.getBoundingClientRect().toJSON()));
  const overlapping = boxes.filter((a, i) => boxes.some((b, j) =>
    i < j && a.left < b.right && b.left < a.right && a.top + 2 < b.bottom && b.top + 2 < a.bottom));
  assert.deepEqual(overlapping, []);
  const hollow = await page.locator('.point .symbol').evaluateAll(
    (symbols) => symbols.filter((s) => s.style.fill === 'var(--panel)').length);
  assert.equal(hollow, 2);

  await page.selectOption('#quantity', { label: 'error of the energy' });
  assert.notDeepEqual(await places(page), first);
  assert.match(await page.textContent('#scatter-title'), /^error of the energy/);
  assert.match(await page.textContent('#unplaced-title'), /^5 variants/);
  const energies = (await texts(page, '.axis text')).filter((text) => text.endsWith('J'));
  assert.ok(energies.length > 2);
  await page.selectOption('#quantity', { label: 'penetration' });
  assert.deepEqual(await texts(page, '.band-title'), ['no value', 'zero']);
  await page.selectOption('#quantity', { index: 0 });
  assert.deepEqual(await places(page), first);
  const colours = () => page.locator('.point .symbol').evaluateAll(
    (symbols) => new Set(symbols.map((s) => s.style.stroke)).size);
  assert.equal(await colours(), results.axes[0].values.length);
  await page.selectOption('#colour', 'filter');
  assert.equal(await colours(), 2);
}

async function tryReasons(page, results) {
  const reasons = await texts(page, '#reasons li');
  assert.equal(reasons.length, 4);
  for (const { status, reason, name } of results.variants) {
    if (['finished', 'not_converged'].includes(status)) continue;
    assert.ok(reasons.includes(`${name}: ${status}, ${reason}`), `${name} in ${reasons}`);
  }
}

async function tryHostileName(page) {
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  assert.equal(await page.locator('img').count(), 0);
  assert.ok((await texts(page, '#table tbody th')).includes(hostileName));
}

async function trySelection(page) {
  await page.click('#select-none');
  assert.equal(await page.locator('.line').count(), 0);
  const row = page.locator('#table tbody tr').nth(3);
  const name = await row.locator('th').textContent();
  await row.hover();
  assert.ok((await page.getAttribute('.point.hovered', 'aria-label')).startsWith(name));
  assert.deepEqual(await texts(page, '#lines-legend li'), [name]);
  await row.locator('input').check();
  await page.mouse.move(0, 0);
  assert.equal(await page.locator('.line').count(), 1);

  await page.locator('.point').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#table tbody tr.selected').count(), 2);
  const focused = await page.evaluate(() => document.activeElement.getAttribute('aria-label'));
  assert.equal(focused, await page.locator('.point').nth(1).getAttribute('aria-label'));
  assert.equal(await page.locator('#tooltip strong').textContent(), focused.split(': ')[0]);
  assert.match(await page.textContent('#tooltip'), /memory at most.*MB/);
}

async function trySorting(page) {
  const column = async (index) => {
    const cells = page.locator(`#table tbody tr td:nth-child(${index + 1})`);
    return cells.allTextContents();
  };
  const heads = await texts(page, '#table thead th');
  const linear = heads.indexOf('linear a step');
  await page.click('#table thead button:text-is("linear a step")');
  const up = (await column(linear)).map(Number);
  const known = up.filter((value) => !Number.isNaN(value));
  assert.ok(known.length > 20);
  assert.deepEqual(known, [...known].sort((a, b) => a - b));
  assert.ok(up.slice(known.length).every(Number.isNaN));
  await page.click('#table thead button:text-is("linear a step")');
  assert.equal(Number((await column(linear))[0]), known.at(-1));
  assert.equal(await page.locator('th[aria-sort="descending"]').count(), 1);
}

const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
try {
  const results = makeResults();
  await withPage(browser, results, async (page) => {
    await showsAll(page, results);
    await tryHostileName(page);
    await tryReasons(page, results);
    await tryPlot(page, results);
    await trySelection(page);
    await trySorting(page);
    assert.match(await page.textContent('#recommendations'), /under 1 mm/);
    assert.match(await page.textContent('#machine'), /Intel Xeon.*GNU/);
    assert.ok(await page.isHidden('#timing-note'));
  });
  const many = ofManyVariants(300);
  await withPage(browser, many, async (page) => {
    await showsAll(page, many);
    assert.match(await page.textContent('#timing-note'), /shared the machine/);
    assert.ok((await page.locator('#legend li').count()) < 20);
  });
  await withPage(browser, ofManyVariants(1), (page) => showsAll(page, ofManyVariants(1)));
  const blind = withoutReference();
  await withPage(browser, blind, async (page) => {
    await showsAll(page, blind);
    assert.match(await page.textContent('#facts'), /no errors/);
    assert.ok(await page.isHidden('#lines'));
    assert.ok(await page.isDisabled('#select-front'));
  });
  await withPage(browser, makeResults({ variants: [], fronts: {} }), async (page) => {
    assert.equal(await page.locator('.point').count(), 0);
  });
} finally {
  await browser.close();
}
