// Colours: of plots, of scales, of hair. Scales are lists of sRGB stops.

/** From low to high; even steps of lightness. */
export const sequential = ['#2b1d5c', '#3b4d9b', '#2a7f9e', '#35a984', '#8fc95a', '#fde047'];
/** From nothing, which is no colour, to much. */
export const heat = ['#595f69', '#84503f', '#d5703a', '#ffb43e', '#fff3b8'];
/** Around zero. */
export const diverging = ['#4aa3ff', '#3d6fc4', '#46536b', '#8a8f98', '#a3644a', '#e07b39', '#ffb454'];

const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/** Colours of a scale as bytes r, g, b, a. */
export function scaleBytes(stops, size = 256) {
  const bytes = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) {
    const place = (i / (size - 1)) * (stops.length - 1);
    const below = Math.min(Math.floor(place), stops.length - 2);
    const [from, to] = [channels(stops[below]), channels(stops[below + 1])];
    for (let c = 0; c < 3; ++c) {
      bytes[4 * i + c] = Math.round(from[c] + (place - below) * (to[c] - from[c]));
    }
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

export const gradient = (stops) => `linear-gradient(to right, ${stops.join(', ')})`;

/** Hues that go round once, for numbers without an order. */
export const cyclic = ['#e5646e', '#e09a3e', '#c3c24a', '#62b866', '#3fb3a8', '#4b94d8', '#8f77dc',
                       '#cf65b4', '#e5646e'];

/** Lines of plots; readable on white and on black. */
export const lines = ['#3b82f6', '#e0793a', '#16a085', '#c2569b', '#8b7bd8', '#a8921f', '#6b7280'];
