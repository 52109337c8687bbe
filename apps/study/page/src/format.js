import { format } from 'd3-format';

/** Units that take a prefix: 0.12 mm reads better than 1.2e-4 m. */
const prefixed = new Set(['m', 's', 'J', 'N', 'B']);
const withPrefix = format('.3~s');
const plain = format('.3~g');

const negativeExponent = (text) => text.replace('−', '-');

/** With three digits and its unit; a dash for what has no value. */
export function quantity(value, unit = '') {
  if (value === null || value === undefined) return '–';
  if (value === 0) return '0';
  if (!prefixed.has(unit)) {
    return negativeExponent(`${plain(value)}${unit && ` ${unit}`}`);
  }
  const [, digits, prefix] = /^(.*?)([^\d]?)$/.exec(negativeExponent(withPrefix(value)));
  return `${digits} ${prefix}${unit}`;
}

const statusWords = { not_converged: 'not converged' };
export const status = (variant) => statusWords[variant.status] ?? variant.status;
