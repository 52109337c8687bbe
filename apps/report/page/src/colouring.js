import { record } from './embedded.js';
import { curvature, speed, torsion } from './measures.js';
import { cyclic, diverging, heat, sequential } from './palette.js';

/**
 * How strands can be coloured. With `signedStops` zero is their middle, if there are both signs. Of
 * `sparse` values most are zero.
 */
export const colourings = {
  hair: { label: 'hair' },
  strand: { label: 'strand', stops: cyclic },
  curvature: { label: 'curvature', unit: '1/m', stops: sequential },
  twist: { label: 'twist (torsion)', unit: '° an edge', stops: sequential, signedStops: diverging },
  speed: { label: 'speed', unit: 'm/s', stops: sequential },
  ...(record.contacts && {
    contact: { label: 'contact force', unit: 'N', stops: heat, sparse: true },
  }),
};

/** Values of a colouring, one a vertex, and the range over the run that its scale shows. */
export class Values {
  #frames;
  #before;
  #after;
  #scales = new Map();

  constructor(frames) {
    this.#frames = frames;
    this.#before = new Float32Array(3 * frames.vertices);
    this.#after = new Float32Array(3 * frames.vertices);
  }

  /** The values at a frame. */
  measure(name, frame, out) {
    if (name === 'contact') return this.#frames.contacts(frame, out);
    const { first } = this.#frames;
    if (name === 'speed') {
      const { before, after, seconds } = this.#frames.speedFrames(frame);
      this.#frames.positions(before, this.#before);
      this.#frames.positions(after, this.#after);
      return speed(this.#before, this.#after, seconds, out);
    }
    this.#frames.positions(frame, this.#before);
    (name === 'curvature' ? curvature : torsion)(this.#before, first, out);
  }

  /** The scale of a colouring: its range, all but the outermost 2 % of some frames, and stops. */
  scale(name) {
    const key = `${name} ${this.#frames.ready}`;
    if (!this.#scales.has(key)) this.#scales.set(key, this.#findScale(name));
    return this.#scales.get(key);
  }

  #findScale(name) {
    const { stops, signedStops, sparse } = colourings[name];
    const [low, high] = this.#findRange(name, sparse ? (value) => value > 0 : () => true);
    if (sparse) return { stops, range: [0, Math.max(high, 1e-12)] };
    if (!signedStops || low * high >= 0) return { stops, range: [low, Math.max(high, low + 1e-9)] };
    const bound = Math.max(-low, high);
    return { stops: signedStops, range: [-bound, bound] };
  }

  #findRange(name, counts) {
    const looks = 7, last = this.#frames.ready - 1;
    const values = new Float32Array(this.#frames.vertices);
    const stride = Math.ceil((looks * values.length) / 200000);
    const sample = [];
    for (let look = 0; look < looks; ++look) {
      this.measure(name, Math.round((look * last) / (looks - 1)), values);
      for (let v = look % stride; v < values.length; v += stride) {
        if (counts(values[v])) sample.push(values[v]);
      }
    }
    if (sample.length === 0) return [0, 0];
    sample.sort((a, b) => a - b);
    return [sample[Math.floor(0.02 * (sample.length - 1))],
            sample[Math.ceil(0.98 * (sample.length - 1))]];
  }
}
