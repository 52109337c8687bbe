import { results } from './embedded.js';
import { definitions, element } from './elements.js';
import { quantity, status } from './format.js';

/** Everything that is known of a variant, as pairs of texts. */
export function factsOf(variant) {
  const { seconds, seconds_low: low, seconds_high: high } = variant;
  const spread = low !== null && high !== null && low < high
    ? ` (${quantity(low, 's')} to ${quantity(high, 's')})` : '';
  const axis = (name) => results.axes?.find((known) => known.name === name);
  return [
    ['status', status(variant)],
    ...(variant.reason ? [['reason', variant.reason]] : []),
    ...Object.entries(variant.values ?? {}).map(([name, value]) => (
      [axis(name)?.label ?? name, `${value} ${axis(name)?.unit ?? ''}`.trim()])),
    ['time', quantity(seconds, 's') + spread],
    ...(results.errors ?? []).map(({ name, label, unit }) => (
      [label, quantity(variant.errors?.[name], unit)])),
    ['Newton, linear iterations a step',
     `${quantity(variant.newton_iterations)}, ${quantity(variant.linear_iterations)}`],
    ['steps', `${variant.steps ?? '–'}, not converged ${variant.steps_not_converged ?? '–'}`],
    ['memory at most', quantity(variant.peak_memory_bytes, 'B')],
  ];
}

const box = document.getElementById('tooltip');

/** Shows what is known of a variant beside a place in the window, px. */
export function showTooltip(variant, x, y) {
  const list = element('dl');
  list.append(...definitions(factsOf(variant)));
  box.replaceChildren(element('strong', variant.name), list);
  box.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = box;
  const left = x + 16 + width > innerWidth ? x - 16 - width : x + 16;
  const top = Math.min(y + 12, innerHeight - height - 8);
  box.style.transform = `translate(${Math.max(4, left)}px, ${Math.max(4, top)}px)`;
}

export function hideTooltip() {
  box.hidden = true;
}
