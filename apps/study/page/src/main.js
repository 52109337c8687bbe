import { symbol, symbolCircle } from 'd3-shape';

import { Appearance, axes } from './appearance.js';
import { definitions, element } from './elements.js';
import { byName, results, variants } from './embedded.js';
import { quantity as words, status } from './format.js';
import { Lines } from './lines.js';
import { frontOf, placeOf, quantities } from './quantities.js';
import { Scatter } from './scatter.js';
import { Selection } from './selection.js';
import { Table } from './table.js';
import { hideTooltip, showTooltip } from './tooltip.js';
import './style.css';

const at = (id) => document.getElementById(id);
const selection = new Selection();
const table = new Table(at('table'), selection);
const lines = new Lines(selection);
const scatter = new Scatter(at('scatter'), selection, (variant, x, y) => {
  if (!variant) return hideTooltip();
  showTooltip(variant, x, y);
  table.show(variant.name);
});

let quantity = quantities[0];

const counted = (number, one, many) => `${number} ${number === 1 ? one : many}`;

function showHead() {
  const { study, duration, repetitions, reference } = results;
  document.title = `${study.name} – Ringlet`;
  at('name').textContent = study.name;
  at('about').textContent = study.about ?? '';
  const ran = `${counted(variants.length, 'variant', 'variants')} of ${study.scene}, ` +
              `${words(duration, 's')} simulated, ${counted(repetitions, 'run', 'runs')} each`;
  at('facts').textContent = reference
    ? `${ran}; compared with ${reference.name ?? 'the reference'} (${words(reference.seconds, 's')})`
    : `${ran}; without a reference there are no errors`;
  at('timing-note').textContent = results.timing_note ?? '';
  at('timing-note').hidden = !results.timing_note;
}

function showAdvice() {
  const advice = results.recommendations?.[quantity.name] ?? [];
  at('advice').hidden = advice.length === 0;
  at('advice-title').textContent = `What to take, by ${quantity.label}`;
  at('recommendations').replaceChildren(...advice.map((text) => element('li', text)));
}

/** Variants that are not in the plot, with the reason: none is left out. */
function showUnplaced() {
  const listed = variants.filter((v) => ['strip', 'list'].includes(placeOf(v, quantity)));
  at('unplaced').hidden = listed.length === 0;
  at('unplaced-title').textContent =
    `${counted(listed.length, 'variant', 'variants')} without a place in the plot`;
  at('reasons').replaceChildren(...listed.map((variant) => {
    const item = element('li');
    const reason = variant.reason || `no value of ${quantity.label}`;
    item.append(element('strong', variant.name), `: ${status(variant)}, ${reason}`);
    item.addEventListener('mouseenter', () => selection.hover(variant.name));
    item.addEventListener('mouseleave', () => selection.hover(null));
    return item;
  }));
}

function legendItem({ text, colour, path, fill = colour }) {
  const item = element('li');
  const drawing = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  drawing.setAttribute('viewBox', '-9 -9 18 18');
  const shape = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  shape.setAttribute('d', path);
  shape.setAttribute('class', 'symbol');
  shape.style.fill = fill;
  shape.style.stroke = colour;
  drawing.append(shape);
  item.append(drawing, text);
  return item;
}

function showLegend(appearance) {
  const items = appearance.legend().flatMap(({ title, entries }) => [
    element('li', title, { class: 'group' }),
    ...entries.map((entry) => legendItem({ ...entry, path: symbol(entry.symbol, 75)() })),
  ]);
  if (variants.some((v) => v.status !== 'finished')) {
    items.push(legendItem({ colour: 'var(--muted)', path: symbol(symbolCircle, 75)(),
                            text: 'not converged or worse', fill: 'var(--panel)' }));
  }
  if (frontOf(quantity).length > 0) {
    items.push(legendItem({ colour: 'var(--accent)', path: 'M-8,4L0,-1L8,-4', fill: 'none',
                            text: 'Pareto front' }));
  }
  at('legend').replaceChildren(...items);
}

function drawPlots() {
  const appearance = new Appearance(at('colour').value, at('symbol').value);
  const unlabelled = scatter.draw(quantity, appearance);
  at('unlabelled').textContent = unlabelled > 0
    ? `There is no room for ${counted(unlabelled, 'label', 'labels')}; the table marks the front.` : '';
  lines.draw(quantity);
  showLegend(appearance);
}

function drawAll() {
  quantity = quantities[at('quantity').value];
  at('scatter-title').textContent = `${quantity.label} against time`;
  at('lines-title').textContent = `${quantity.label} over time`;
  document.body.classList.toggle('no-lines', !quantity.isError);
  at('select-front').disabled = frontOf(quantity).length === 0;
  showAdvice();
  showUnplaced();
  table.draw(quantity);
  drawPlots();
}

function fillSelects() {
  at('quantity').append(...quantities.map(({ label }, i) => element('option', label, { value: i })));
  const of = (variant) => Object.keys(variant.values ?? {});
  const varied = axes.filter(({ name }) => variants.some((v) => of(v).includes(name)));
  for (const [id, first] of [['colour', 0], ['symbol', 1]]) {
    at(id).append(element('option', 'all alike', { value: '' }),
                  ...varied.map((axis) => element('option', axis.label ?? axis.name, { value: axis.name })));
    at(id).value = varied[first]?.name ?? '';
    at(id).addEventListener('change', drawPlots);
  }
  at('quantity').addEventListener('change', drawAll);
}

/** The default and some of the front, so that there is something to see over time. */
function selectFirst() {
  const front = frontOf(quantity).filter((name) => byName.has(name));
  const picked = [0, 0.5, 1].map((share) => front[Math.round(share * (front.length - 1))]);
  const names = [results.default, ...picked].filter((name) => byName.has(name));
  selection.replace([...new Set(names)]);
}

at('select-front').addEventListener('click', () => selection.replace(frontOf(quantity)));
at('select-none').addEventListener('click', () => selection.replace([]));

showHead();
at('machine').append(...definitions(Object.entries(results.machine ?? {}).map(
  ([name, value]) => [name.replaceAll('_', ' '), String(value)])));
fillSelects();
drawAll();
selectFirst();

let width = at('scatter').clientWidth;
new ResizeObserver(() => {
  if (at('scatter').clientWidth === width) return;
  width = at('scatter').clientWidth;
  drawPlots();
}).observe(at('scatter'));
document.body.dataset.loaded = 'yes';
