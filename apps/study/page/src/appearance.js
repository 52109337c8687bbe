import { scaleSequential } from 'd3-scale';
import { symbolsFill } from 'd3-shape';

import { results } from './embedded.js';

/** Of kinds; readable on white and on black. */
const kinds = ['#3b82f6', '#e0793a', '#16a085', '#c2569b', '#8b7bd8', '#a8921f', '#d0504f', '#4aa3b8'];
/** Of what has no value of the axis. */
const grey = '#8a8f98';
/** Of selected variants. */
export const lineColours = ['#d0504f', '#3b82f6', '#16a085', '#e0793a', '#8b7bd8', '#c2569b', '#a8921f',
                            '#4aa3b8'];

/** From low to high, when the values of an axis are numbers or too many for kinds: blue to orange. */
const ordered = scaleSequential((t) => `hsl(${Math.round(228 + 158 * t)} 66% ${Math.round(55 - 3 * t)}%)`);

export const axes = results.axes ?? [];
const axisOf = (name) => axes.find((axis) => axis.name === name);
/** Label and unit of an axis. */
export const titleOf = ({ label, name, unit }) => (unit ? `${label ?? name}, ${unit}` : (label ?? name));
const valuesOf = (axis) => (axis?.values ?? []).map(String);

function colours(values) {
  const numbers = values.every((value) => value.trim() !== '' && Number.isFinite(Number(value)));
  if (!numbers && values.length <= kinds.length) return values.map((_, i) => kinds[i]);
  const sorted = numbers ? [...values].sort((a, b) => a - b) : values;
  return values.map((value) => ordered(sorted.indexOf(value) / Math.max(1, values.length - 1)));
}

/** Colours tell the values of one axis and symbols those of another; both may be absent. */
export class Appearance {
  #colourAxis;
  #symbolAxis;
  #colours;

  constructor(colourName, symbolName) {
    this.#colourAxis = axisOf(colourName);
    this.#symbolAxis = axisOf(symbolName);
    this.#colours = colours(valuesOf(this.#colourAxis));
  }

  #index(axis, variant) {
    return axis ? valuesOf(axis).indexOf(String(variant.values?.[axis.name])) : -1;
  }
  colour(variant) {
    if (!this.#colourAxis) return kinds[0];
    return this.#colours[this.#index(this.#colourAxis, variant)] ?? grey;
  }
  symbol(variant) {
    return this.#symbolOf(this.#index(this.#symbolAxis, variant));
  }
  #symbolOf(index) {
    return symbolsFill[Math.max(index, 0) % symbolsFill.length];
  }

  /** Of both axes: {title, entries: {text, colour, symbol}}. */
  legend() {
    const same = this.#colourAxis === this.#symbolAxis;
    const byColour = (i) => ({ colour: this.#colours[i], symbol: this.#symbolOf(same ? i : 0) });
    const bySymbol = (i) => ({ colour: 'var(--muted)', symbol: this.#symbolOf(i) });
    return [[this.#colourAxis, byColour], [same ? null : this.#symbolAxis, bySymbol]]
      .filter(([axis]) => axis)
      .map(([axis, look]) => ({
        title: titleOf(axis),
        entries: thinned(valuesOf(axis).map((value, i) => ({ text: value, ...look(i) }))),
      }));
  }
}

/** Of very many some, evenly, with the first and the last. */
function thinned(entries, most = 12) {
  if (entries.length <= most) return entries;
  return Array.from({ length: most },
                    (_, i) => entries[Math.round(i * (entries.length - 1) / (most - 1))]);
}
