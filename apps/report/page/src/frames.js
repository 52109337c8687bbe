import { decodeFrames } from './decode.js';
import { packedContacts, packedFrames, record, unpack } from './embedded.js';

/** The embedded frames; they arrive one packet after another. */
export class Frames {
  times = record.frames.times;
  steps = record.frames.steps;
  first = Uint32Array.from(record.strands.first);
  vertices = this.first[this.first.length - 1];
  #quantised = [];
  #contacts = [];

  get count() {
    return this.times.length;
  }
  /** How many are there yet. */
  get ready() {
    return this.#quantised.length;
  }

  /** Unpacks everything and calls onArrival after each packet. */
  async load(onArrival) {
    const take = async (element) => {
      const bytes = await unpack(element.textContent);
      element.remove();
      return bytes;
    };
    for (const [i, packet] of packedFrames.entries()) {
      const bytes = await take(packet);
      if (packedContacts[i]) this.#addContacts(await take(packedContacts[i]));
      this.#quantised.push(...decodeFrames(bytes, this.first));
      onArrival();
    }
  }

  #addContacts(bytes) {
    for (let at = 0; at < bytes.length; at += this.vertices) {
      this.#contacts.push(bytes.subarray(at, at + this.vertices));
    }
  }

  /** How hard contacts push each vertex at a frame, N. */
  contacts(frame, out) {
    const { largest } = record.contacts;
    this.#contacts[frame].forEach((byte, v) => {
      out[v] = largest * (byte / 255) ** 2;
    });
  }

  /** Positions in m at a frame: x, y, z a vertex, each `stride` after the one before. */
  positions(frame, out, stride = 3) {
    this.#combine([frame], [1], out, stride);
  }

  /** The frames between which a frame's speed is measured, and the seconds between these. */
  speedFrames(frame) {
    const before = Math.max(frame - 1, 0);
    const after = Math.min(frame + 1, this.ready - 1);
    return { before, after, seconds: this.times[after] - this.times[before] };
  }

  /**
   * Positions at a time between two frames, on the cubic through them whose slopes are the central
   * differences: what was thinned out is so played smoothly.
   */
  positionsAt(frame, fraction, out, stride) {
    if (fraction === 0 || frame + 1 >= this.ready) return this.positions(frame, out, stride);
    const last = this.ready - 1;
    const at = [Math.max(frame - 1, 0), frame, frame + 1, Math.min(frame + 2, last)];
    this.#combine(at, this.#cubicWeights(at, fraction), out, stride);
  }

  #cubicWeights(at, s) {
    const [t0, t1, t2, t3] = at.map((frame) => this.times[frame]);
    const slope1 = ((s ** 3 - 2 * s ** 2 + s) * (t2 - t1)) / (t2 - t0);
    const slope2 = ((s ** 3 - s ** 2) * (t2 - t1)) / (t3 - t1);
    const value2 = 3 * s ** 2 - 2 * s ** 3;
    return [-slope1, 1 - value2 - slope2, value2 + slope1, slope2];
  }

  #combine(frames, weights, out, stride) {
    const { low, step } = record.frames;
    const [a, b, c, d] = frames.map((frame) => this.#quantised[frame]);
    for (let axis = 0; axis < 3; ++axis) {
      const [wa, wb, wc, wd] = weights.map((weight) => weight * step[axis]);
      const base = low[axis], values = 3 * this.vertices;
      if (b === undefined) {
        for (let i = axis, o = axis; i < values; i += 3, o += stride) out[o] = base + wa * a[i];
      } else {
        for (let i = axis, o = axis; i < values; i += 3, o += stride) {
          out[o] = base + wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
        }
      }
    }
  }
}
