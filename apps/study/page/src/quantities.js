// What the upright axis can show: the errors of the study, and what needs no reference.
import { results, variants } from './embedded.js';

const errors = (results.errors ?? []).map((error) => ({
  ...error,
  isError: true,
  of: (variant) => variant.errors?.[error.name] ?? null,
}));

const costs = [
  { name: 'newton_iterations', label: 'Newton iterations a step', unit: '' },
  { name: 'linear_iterations', label: 'linear iterations a step', unit: '' },
  { name: 'peak_memory_bytes', label: 'memory at most', unit: 'B' },
].map((cost) => ({ ...cost, isError: false, of: (variant) => variant[cost.name] ?? null }));

export const quantities =
  [...errors.filter(({ of }) => results.reference || variants.some((v) => of(v) !== null)), ...costs];

const ran = new Set(['finished', 'not_converged']);

/**
 * Where a variant stands: `plot`, `zero` (below the logarithmic axis), `strip` (it has a time but no
 * value that means something) or `list` (no time either).
 */
export function placeOf(variant, quantity) {
  if (!(variant.seconds > 0)) return 'list';
  const value = ran.has(variant.status) ? quantity.of(variant) : null;
  if (value === null || value < 0) return 'strip';
  return value === 0 ? 'zero' : 'plot';
}

/** Names of the variants that no other beats in both time and error, fastest first. */
export const frontOf = (quantity) => results.fronts?.[quantity.name] ?? [];
