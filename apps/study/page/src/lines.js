import { axisBottom, axisLeft } from 'd3-axis';
import { scaleLinear } from 'd3-scale';
import { select } from 'd3-selection';
import { line } from 'd3-shape';

import { lineColours } from './appearance.js';
import { element } from './elements.js';
import { byName } from './embedded.js';
import { quantity as words } from './format.js';
import { logScale, logTicks } from './log_axis.js';

const margin = { top: 16, right: 14, bottom: 46, left: 66 };

/** Points [time, value] of a variant; null where a value cannot be on a logarithmic axis. */
const pointsOf = (variant, name) =>
  (variant.at ?? []).map((at) => [at.time, at[name] > 0 ? at[name] : null]);

/** Errors over the time of the simulation, of the variants that are pointed at or selected. */
export class Lines {
  #selection;
  #quantity;
  #plot = document.getElementById('lines');
  #legend = document.getElementById('lines-legend');

  constructor(selection) {
    this.#selection = selection;
    selection.addEventListener('change', () => this.draw(this.#quantity));
  }

  draw(quantity) {
    this.#quantity = quantity;
    const { hovered, names } = this.#selection;
    const shown = hovered !== null && !this.#selection.has(hovered) ? [...names, hovered] : names;
    const lines = shown.map((name) => ({
      name, points: pointsOf(byName.get(name), quantity.name), hovered: name === hovered,
      colour: lineColours[this.#selection.slot(name)] ?? 'var(--text)',
    }));
    this.#drawLegend(lines);
    const drawn = lines.filter(({ points }) => points.some(([, value]) => value !== null));
    if (drawn.length > 0) this.#drawPlot(drawn, quantity);
    else this.#plot.replaceChildren(element('p', this.#absence(shown), { class: 'empty' }));
  }

  #absence(shown) {
    if (shown.length === 0) return 'Point at a variant or select some to see their errors over time.';
    return 'None of the selected variants has a value above zero.';
  }

  #drawPlot(lines, quantity) {
    const width = Math.max(280, this.#plot.clientWidth), height = 400;
    const points = lines.flatMap((each) => each.points);
    const values = points.map(([, value]) => value).filter((value) => value !== null);
    const last = Math.max(...points.map(([time]) => time));
    const x = scaleLinear([0, last], [margin.left, width - margin.right]);
    const y = logScale(values, [height - margin.bottom, margin.top]);
    const svg = select(this.#plot).html('').append('svg').attr('viewBox', `0 0 ${width} ${height}`)
      .attr('role', 'img').attr('aria-label', `${quantity.label} over time`);
    const axis = (transform, made) =>
      svg.append('g').attr('class', 'axis').attr('transform', transform).call(made);
    axis(`translate(0 ${height - margin.bottom})`,
         axisBottom(x).ticks(6).tickSize(6).tickPadding(4).tickFormat((t) => words(t, 's')));
    axis(`translate(${margin.left} 0)`,
         axisLeft(y).tickValues(logTicks(y.domain())).tickFormat((t) => words(t, quantity.unit))
           .tickSize(-(width - margin.left - margin.right)).tickPadding(8));
    svg.append('text').attr('class', 'axis-title').attr('text-anchor', 'end')
      .attr('x', width - margin.right).attr('y', height - 6).text('simulated time');
    const path = line().defined(([, value]) => value !== null)
      .x(([time]) => x(time)).y(([, value]) => y(value));
    svg.append('g').selectAll('path').data(lines).join('path').attr('class', 'line')
      .classed('hovered', (each) => each.hovered)
      .style('stroke', ({ colour }) => colour).attr('d', (each) => path(each.points));
  }

  #drawLegend(lines) {
    this.#legend.replaceChildren(...lines.map(({ name, colour, hovered }) => {
      const item = element('li', '', hovered ? { class: 'hovered' } : {});
      const swatch = element('span', '', { class: 'swatch' });
      swatch.style.background = colour;
      item.append(swatch, element('span', name));
      return item;
    }));
  }
}
