import uPlot from 'uplot';

import { record } from './embedded.js';
import { lines } from './palette.js';

const { names, columns } = record.metrics;
const column = (name) => columns[names.indexOf(name)];
const words = (name) => name.replace(/_ms$/, '').replaceAll('_', ' ');

const energies = names.filter((name) => name.startsWith('energy_'));

/** What is drawn, with its unit. */
const plots = [
  { title: 'Energy', unit: 'J', of: ['kinetic_energy', ...energies],
    label: (name) => (name === 'kinetic_energy' ? 'kinetic' : words(name.slice(7))) },
  { title: 'Iterations a step', unit: '', of: ['newton_iterations', 'linear_iterations'],
    label: (name) => words(name).split(' ')[0] },
  { title: 'Contacts', unit: '', of: ['strand_contacts', 'collider_contacts'],
    label: (name) => `with ${words(name).split(' ')[0]}s` },
  { title: 'Time of a step by stage', unit: 'ms',
    of: ['detect_ms', 'couple_ms', 'evaluate_ms', 'solve_ms', 'line_search_ms', 'step_ms'],
    label: (name) => (name === 'step_ms' ? 'the whole step' : words(name)) },
];

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function short(value) {
  if (value === null || value === undefined) return '';
  return Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3)
    ? value.toExponential(1).replace('e+', 'e') : String(+value.toPrecision(3));
}

/** The marker of the shown time, and seeking with a click. */
function timeLine(marks, onSeek) {
  return {
    hooks: {
      init: (plot) => {
        const mark = document.createElement('div');
        mark.className = 'now';
        plot.over.append(mark);
        marks.push((time) => {
          mark.style.transform = `translateX(${plot.valToPos(time, 'x')}px)`;
        });
        let pressedAt = 0;
        plot.over.addEventListener('mousedown', (event) => {
          pressedAt = event.clientX;
        });
        plot.over.addEventListener('click', (event) => {
          const dragged = Math.abs(event.clientX - pressedAt) > 3;  // to zoom
          if (!dragged) onSeek(plot.posToVal(event.offsetX, 'x'));
        });
      },
    },
  };
}

function options(spec, shown, width, marks, onSeek) {
  const axis = { stroke: css('--muted'), grid: { stroke: css('--line'), width: 1 },
                 ticks: { stroke: css('--line'), width: 1 }, font: '11px system-ui, sans-serif' };
  return {
    width, height: 150, padding: [8, 12, 0, 0],
    scales: { x: { time: false } },
    legend: { live: true },
    cursor: { y: false, drag: { x: true, y: false }, points: { size: 5 } },
    axes: [{ ...axis, size: 26, values: (_, ticks) => ticks.map((t) => `${+t.toPrecision(6)}`) },
           { ...axis, size: 52, values: (_, ticks) => ticks.map(short) }],
    series: [
      { label: 's', value: (_, v) => (v === null ? '' : v.toFixed(3)) },
      ...shown.map((name, i) => ({
        label: spec.label(name), stroke: lines[i % lines.length], width: 1.25,
        value: (_, v) => short(v), points: { show: false },
      })),
    ],
    plugins: [timeLine(marks, onSeek)],
  };
}

/** Draws all plots into an element; returns a function that marks a time. */
export function drawPlots(parent, onSeek) {
  const marks = [];
  let now = 0;
  const build = () => {
    marks.length = 0;
    parent.replaceChildren();
    for (const spec of plots) {
      const shown = spec.of.filter((name) => column(name)?.some((value) => value !== null));
      if (shown.length === 0) continue;
      const figure = document.createElement('figure');
      const caption = document.createElement('figcaption');
      caption.textContent = spec.unit ? `${spec.title}, ${spec.unit}` : spec.title;
      figure.append(caption);
      parent.append(figure);
      new uPlot(options(spec, shown, parent.clientWidth, marks, onSeek),
                [column('time'), ...shown.map(column)], figure);
    }
    marks.forEach((mark) => mark(now));
  };
  if ((column('time')?.length ?? 0) === 0) {
    parent.textContent = 'metrics.csv holds no whole step.';
    return () => {};
  }
  build();
  let width = parent.clientWidth;
  new ResizeObserver(() => {
    if (parent.clientWidth === width) return;
    width = parent.clientWidth;
    build();
  }).observe(parent);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', build);
  return (time) => {
    now = time;
    marks.forEach((mark) => mark(time));
  };
}
