import { axisBottom, axisLeft } from 'd3-axis';
import { select } from 'd3-selection';
import { symbol } from 'd3-shape';

import { lineColours } from './appearance.js';
import { byName, results, variants } from './embedded.js';
import { quantity as words, status } from './format.js';
import { boxesAlong, placeLabels } from './labels.js';
import { logScale, logTicks } from './log_axis.js';
import { frontOf, placeOf } from './quantities.js';

const margin = { top: 16, right: 20, bottom: 46, left: 78 };
const bandHeight = 30;
const longestLabel = 44;

/** What tells a variant from the others that are labelled: the values of axes that vary among them. */
function labelOf(variant, labelled) {
  const varied = Object.entries(variant.values ?? {})
    .filter(([axis, value]) => labelled.some((other) => other.values?.[axis] !== value));
  const text = varied.length > 0 ? varied.map((pair) => pair.join('=')).join(', ') : variant.name;
  return text.length > longestLabel ? `${text.slice(0, longestLabel - 1)}…` : text;
}

const ruler = document.createElement('canvas').getContext('2d');
function textWidth(text) {
  ruler.font = '600 12px system-ui, "Segoe UI", "DejaVu Sans", sans-serif';
  return ruler.measureText(text).width + 2;
}

/** Where things are: scales, the frame of the plot, and bands for what has no place in it. */
function layOut(width, height, shown, quantity) {
  const of = (place) => shown.filter((variant) => placeOf(variant, quantity) === place);
  const [plotted, zero, strip] = ['plot', 'zero', 'strip'].map(of);
  const top = margin.top + (strip.length > 0 ? bandHeight : 0);
  const bottom = height - margin.bottom - (zero.length > 0 ? bandHeight : 0);
  const ends = (v) => [v.seconds, v.seconds_low ?? v.seconds, v.seconds_high ?? v.seconds];
  const times = [...plotted, ...zero, ...strip].flatMap(ends).filter((seconds) => seconds > 0);
  const x = logScale(times, [margin.left, width - margin.right]);
  const y = logScale(plotted.map(quantity.of), [bottom, top]);
  const heights = { plot: (v) => y(quantity.of(v)), zero: () => bottom + bandHeight / 2,
                    strip: () => top - bandHeight / 2 };
  const at = (variant) => ({ x: x(variant.seconds), y: heights[placeOf(variant, quantity)](variant) });
  return { x, y, at, top, bottom, left: margin.left, right: width - margin.right, height,
           plotted, hasZero: zero.length > 0, hasStrip: strip.length > 0 };
}

function drawGrid(svg, frame, quantity) {
  const [xTicks, yTicks] = [logTicks(frame.x.domain()), logTicks(frame.y.domain())];
  const floor = frame.height - margin.bottom;
  const bottom = axisBottom(frame.x).tickValues(xTicks).tickFormat((t) => words(t, 's'))
    .tickSize(-(floor - frame.top)).tickPadding(8);
  const left = axisLeft(frame.y).tickValues(yTicks).tickFormat((t) => words(t, quantity.unit))
    .tickSize(-(frame.right - frame.left)).tickPadding(8);
  svg.append('g').attr('class', 'axis').attr('transform', `translate(0 ${floor})`).call(bottom);
  if (frame.plotted.length > 0) {
    svg.append('g').attr('class', 'axis').attr('transform', `translate(${frame.left} 0)`).call(left);
  }
  svg.append('text').attr('class', 'axis-title').attr('text-anchor', 'end')
    .attr('x', frame.right).attr('y', frame.height - 6).text('time of all steps');
  svg.append('text').attr('class', 'axis-title')
    .attr('transform', `translate(14 ${(frame.top + frame.bottom) / 2}) rotate(-90)`)
    .attr('text-anchor', 'middle').text(quantity.label);
}

function drawBand(svg, frame, top, text) {
  svg.append('rect').attr('class', 'band').attr('x', frame.left).attr('y', top + 2)
    .attr('width', frame.right - frame.left).attr('height', bandHeight - 4);
  svg.append('text').attr('class', 'band-title').attr('x', frame.left - 8)
    .attr('y', top + bandHeight / 2).attr('dy', '0.35em').attr('text-anchor', 'end').text(text);
}

function drawSpreads(svg, frame, shown) {
  const spread = shown.filter((v) => v.seconds_low > 0 && v.seconds_low < v.seconds_high);
  svg.append('g').selectAll('line').data(spread).join('line').attr('class', 'spread')
    .attr('x1', (v) => frame.x(v.seconds_low)).attr('x2', (v) => frame.x(v.seconds_high))
    .attr('y1', (v) => frame.at(v).y).attr('y2', (v) => frame.at(v).y);
}

/** The front's line and the labels of its points and of the default; tells how many have no room. */
function drawFront(svg, frame, shown, quantity) {
  const front = frontOf(quantity).map((name) => byName.get(name))
    .filter((v) => v && ['plot', 'zero'].includes(placeOf(v, quantity)));
  const places = front.map(frame.at);
  svg.append('path').attr('class', 'front')
    .attr('d', places.length > 1 ? `M${places.map((p) => `${p.x},${p.y}`).join('L')}` : null);
  const isDefault = (variant) => variant.name === results.default;
  const standing = shown.find((v) => isDefault(v) && placeOf(v, quantity) !== 'list');
  // What comes first finds room first.
  const named = [...new Set([standing, front.at(-1), ...front])].filter((v) => v);
  const labels = named.map((variant) => {
    const text = labelOf(variant, named) + (isDefault(variant) ? ' (default)' : '');
    return { variant, text, ...frame.at(variant), width: textWidth(text), height: 15 };
  });
  const dots = shown.map(frame.at).map(({ x, y }) => ({ x: x - 6, y: y - 6, width: 12, height: 12 }));
  const bounds = { x: frame.left, y: frame.top, width: frame.right + margin.right - frame.left - 2,
                   height: frame.bottom - frame.top };
  const boxes = placeLabels(labels, [...dots, ...boxesAlong(places)], bounds);
  const placed = labels.map((label, i) => ({ ...label, box: boxes[i] })).filter(({ box }) => box);
  svg.append('g').selectAll('line').data(placed).join('line').attr('class', 'leader')
    .attr('x1', ({ x }) => x).attr('y1', ({ y }) => y)
    .attr('x2', ({ x, box }) => Math.min(Math.max(x, box.x), box.x + box.width))
    .attr('y2', ({ y, box }) => Math.min(Math.max(y, box.y), box.y + box.height));
  svg.append('g').selectAll('text').data(placed).join('text').attr('class', 'label')
    .attr('x', ({ box }) => box.x + 1).attr('y', ({ box }) => box.y + 12).text(({ text }) => text);
  return labels.length - placed.length;
}

/** Error against time: a symbol a variant, of which one is reached by Tab and others by arrow keys. */
export class Scatter {
  #parent;
  #selection;
  #onPoint;
  #points = select(null);

  /** onPoint(variant or null, x, y): the reader points at a variant, in the window at x, y px. */
  constructor(parent, selection, onPoint) {
    this.#parent = parent;
    this.#selection = selection;
    this.#onPoint = onPoint;
    selection.addEventListener('change', () => this.#mark());
  }

  /** Tells how many labels have no room. */
  draw(quantity, appearance) {
    const width = Math.max(320, this.#parent.clientWidth);
    const height = Math.round(Math.min(620, Math.max(380, 0.62 * width)));
    const shown = variants.filter((variant) => placeOf(variant, quantity) !== 'list');
    const frame = layOut(width, height, shown, quantity);
    const svg = select(this.#parent).html('').append('svg').attr('viewBox', `0 0 ${width} ${height}`)
      .attr('role', 'group').attr('aria-label', `${quantity.label} against time`);
    drawGrid(svg, frame, quantity);
    if (frame.hasStrip) drawBand(svg, frame, frame.top - bandHeight, 'no value');
    if (frame.hasZero) drawBand(svg, frame, frame.bottom, 'zero');
    drawSpreads(svg, frame, shown);
    const unlabelled = drawFront(svg, frame, shown, quantity);
    this.#drawPoints(svg, frame, shown, quantity, appearance);
    this.#mark();
    return unlabelled;
  }

  #drawPoints(svg, frame, shown, quantity, appearance) {
    const order = [...shown].sort((a, b) => a.seconds - b.seconds);
    const hollow = (variant) => variant.status !== 'finished';
    this.#points = svg.append('g').selectAll('g').data(order).join('g')
      .attr('class', 'point').attr('role', 'button')
      .attr('tabindex', (_, i) => (i === 0 ? 0 : -1))
      .attr('aria-label', (v) => `${v.name}: ${status(v)}, ${words(v.seconds, 's')}, ` +
                                 words(quantity.of(v), quantity.unit))
      .attr('transform', (v) => `translate(${frame.at(v).x} ${frame.at(v).y})`)
      .classed('default', (v) => v.name === results.default)
      .on('mouseenter', (event, v) => this.#point(v, event.clientX, event.clientY))
      .on('mouseleave', () => this.#point(null))
      .on('focus', (event, v) => {
        const { right, bottom } = event.currentTarget.getBoundingClientRect();
        this.#point(v, right, bottom);
      })
      .on('blur', () => this.#point(null))
      .on('click', (_, v) => this.#selection.toggle(v.name))
      .on('keydown', (event, v) => this.#key(event, v));
    this.#points.append('circle').attr('class', 'target').attr('r', 10);
    this.#points.append('circle').attr('class', 'ring').attr('r', 10);
    this.#points.append('path').attr('class', 'symbol')
      .attr('d', (v) => symbol(appearance.symbol(v), v.name === results.default ? 130 : 75)())
      .style('stroke', appearance.colour.bind(appearance))
      .style('fill', (v) => (hollow(v) ? 'var(--panel)' : appearance.colour(v)));
    this.#points.filter((v) => v.name === results.default).raise();
  }

  #point(variant, x, y) {
    this.#selection.hover(variant?.name ?? null);
    this.#onPoint(variant, x, y);
  }

  #key(event, variant) {
    const nodes = this.#points.nodes();
    const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
    if (event.key === 'Enter' || event.key === ' ') this.#selection.toggle(variant.name);
    else if (event.key in steps) {
      const here = nodes.indexOf(event.currentTarget);
      const next = nodes[(here + steps[event.key] + nodes.length) % nodes.length];
      event.currentTarget.setAttribute('tabindex', -1);
      next.setAttribute('tabindex', 0);
      next.focus();
    } else return;
    event.preventDefault();
  }

  #mark() {
    const { hovered } = this.#selection;
    this.#points.classed('hovered', (v) => v.name === hovered)
      .attr('aria-pressed', (v) => this.#selection.has(v.name))
      .select('.ring').style('stroke', (v) => lineColours[this.#selection.slot(v.name)] ?? null);
  }
}
