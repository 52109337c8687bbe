import { scaleLinear, scaleLog } from 'd3-scale';

/** Round numbers between two, few enough to be read: over decades, powers of ten, 2 and 5 times them. */
export function logTicks([low, high]) {
  const decades = Math.log10(high / low);
  if (decades < 0.7) return scaleLinear([low, high], [0, 1]).ticks(6);
  const leading = decades < 1.3 ? [1, 1.5, 2, 3, 4, 5, 7] : decades < 3.2 ? [1, 2, 5] : [1];
  const every = Math.ceil(decades / 9);
  const ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
    if (power % every !== 0) continue;
    for (const digit of leading) {
      const tick = Number(`${digit}e${power}`);
      if (tick >= low && tick <= high) ticks.push(tick);
    }
  }
  return ticks;
}

/** A logarithmic scale around some positive values, with a margin. */
export function logScale(values, range, margin = 0.06) {
  const low = values.length > 0 ? Math.min(...values) : 0.1;
  const high = values.length > 0 ? Math.max(...values) : 1;
  const factor = Math.max((high / low) ** margin, 1.3);
  return scaleLog([low / factor, high * factor], range);
}
