import { lineColours, titleOf } from './appearance.js';
import { element } from './elements.js';
import { results, variants } from './embedded.js';
import { quantity as words, status } from './format.js';
import { frontOf } from './quantities.js';

const axisValue = (variant, name) => variant.values?.[name] ?? null;
const number = (text) => (text !== null && text.trim() !== '' && Number.isFinite(Number(text))
  ? Number(text) : text);

/** Columns: {title, of: what rows are sorted by, text: what a cell says}. */
function columnsFor(quantity) {
  const front = new Set(frontOf(quantity));
  const numbers = (title, of, unit = '') => ({ title, of, text: (v) => words(of(v), unit), right: true });
  const spread = ({ seconds_low: low, seconds_high: high }) => (low > 0 && high > low ? high / low : null);
  return [
    { title: 'front', of: (v) => (front.has(v.name) ? 0 : 1), text: (v) => (front.has(v.name) ? '●' : '') },
    { title: 'variant', of: (v) => v.name, isName: true,
      text: (v) => v.name + (v.name === results.default ? ' (default)' : '') },
    { title: 'status', of: status, text: (v) => status(v), hint: (v) => v.reason },
    ...(results.axes ?? []).map((axis) => ({
      title: titleOf(axis), of: (v) => number(axisValue(v, axis.name)), right: true,
      text: (v) => axisValue(v, axis.name) ?? '–' })),
    numbers('time', (v) => v.seconds ?? null, 's'),
    ...(results.repetitions > 1
      ? [{ title: 'spread', of: spread, right: true,
           text: (v) => (spread(v) === null ? '–' : `${words(v.seconds_low, 's')} to ${words(v.seconds_high, 's')}`) }]
      : []),
    ...(results.errors ?? []).map(({ name, label, unit }) => (
      numbers(label, (v) => v.errors?.[name] ?? null, unit))),
    numbers('Newton a step', (v) => v.newton_iterations ?? null),
    numbers('linear a step', (v) => v.linear_iterations ?? null),
    numbers('not converged', (v) => v.steps_not_converged ?? null),
    numbers('memory', (v) => v.peak_memory_bytes ?? null, 'B'),
  ];
}

/** Numbers before texts, and what has no value last whatever the direction. */
function compare(a, b, direction) {
  if (a === null || b === null) return (a === null) - (b === null);
  if (typeof a !== typeof b) return typeof a === 'number' ? -1 : 1;
  return direction * (typeof a === 'number' ? a - b : a.localeCompare(b, 'en', { numeric: true }));
}

/** All variants; a row for each, which can be sorted and selected. */
export class Table {
  #parent;
  #selection;
  #onSort = { title: 'time', direction: 1 };
  #columns = [];
  #rows = new Map();

  constructor(parent, selection) {
    this.#parent = parent;
    this.#selection = selection;
    selection.addEventListener('change', () => this.#mark());
  }

  draw(quantity) {
    this.#columns = columnsFor(quantity);
    this.#rows = new Map(variants.map((variant) => [variant.name, this.#row(variant)]));
    const table = element('table'), head = element('thead'), row = element('tr');
    row.append(element('th', 'selected', { scope: 'col' }), ...this.#columns.map((column) => this.#head(column)));
    head.append(row);
    table.append(head, element('tbody'));
    this.#parent.replaceChildren(table);
    this.#sort();
    this.#mark();
  }

  #head(column) {
    const head = element('th', '', { scope: 'col' });
    const button = element('button', column.title, { type: 'button' });
    button.addEventListener('click', () => {
      const again = this.#onSort.title === column.title;
      this.#onSort = { title: column.title, direction: again ? -this.#onSort.direction : 1 };
      this.#sort();
    });
    head.classList.toggle('right', column.right ?? false);
    head.append(button);
    return head;
  }

  #row(variant) {
    const row = element('tr', '', { class: variant.status });
    const box = element('input', '', { type: 'checkbox', 'aria-label': `select ${variant.name}` });
    box.addEventListener('change', () => this.#selection.toggle(variant.name));
    const cell = element('td');
    cell.append(box);
    row.append(cell, ...this.#columns.map((column) => this.#cell(column, variant)));
    for (const enter of ['mouseenter', 'focusin']) {
      row.addEventListener(enter, () => this.#selection.hover(variant.name));
    }
    for (const leave of ['mouseleave', 'focusout']) {
      row.addEventListener(leave, () => this.#selection.hover(null));
    }
    return row;
  }

  #cell(column, variant) {
    const hint = column.hint?.(variant);
    const cell = element(column.isName ? 'th' : 'td', column.text(variant),
                         { ...(column.isName && { scope: 'row' }), ...(hint && { title: hint }) });
    cell.classList.toggle('right', column.right ?? false);
    return cell;
  }

  #sort() {
    const { title, direction } = this.#onSort;
    const column = this.#columns.find((each) => each.title === title) ?? this.#columns[0];
    const order = [...variants].sort((a, b) => compare(column.of(a), column.of(b), direction));
    this.#parent.querySelector('tbody').replaceChildren(...order.map((v) => this.#rows.get(v.name)));
    this.#parent.querySelectorAll('thead th').forEach((head, i) => {
      const sorted = this.#columns[i - 1]?.title === title;
      if (sorted) head.setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
      else head.removeAttribute('aria-sort');
    });
  }

  #mark() {
    const { hovered } = this.#selection;
    for (const [name, row] of this.#rows) {
      const box = row.querySelector('input');
      box.checked = this.#selection.has(name);
      box.style.accentColor = lineColours[this.#selection.slot(name)] ?? '';
      row.classList.toggle('hovered', name === hovered);
      row.classList.toggle('selected', box.checked);
    }
  }

  /** Scrolls the table, not the window, to the row of a variant. */
  show(name) {
    const row = this.#rows.get(name);
    const { clientHeight } = this.#parent;
    const above = row.offsetTop - 40 < this.#parent.scrollTop;
    const below = row.offsetTop + row.offsetHeight > this.#parent.scrollTop + clientHeight;
    if (above || below) this.#parent.scrollTop = row.offsetTop - clientHeight / 2;
  }
}
