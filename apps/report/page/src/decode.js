// The inverse of frame_packer.cpp.

/**
 * Frames of positions, quantised: for each frame an Uint16Array of x, y, z a vertex.
 *
 * A coordinate is written as its change since the frame before (in the first of the bytes: since
 * zero), less that of the vertex before on its strand; zigzag, modulo 2^16; of a frame first the
 * low bytes of all x, all y, all z, then the high bytes.
 *
 * @param bytes unpacked
 * @param first index of the first vertex of each strand, and at its end the number of vertices
 */
export function decodeFrames(bytes, first) {
  const vertices = first[first.length - 1];
  const values = 3 * vertices;
  const frames = [];
  for (let at = 0; at < bytes.length; at += 2 * values) {
    const frame = new Uint16Array(values);
    const before = frames.length > 0 ? frames[frames.length - 1] : new Uint16Array(values);
    for (let axis = 0; axis < 3; ++axis) {
      decodeAxis(bytes, at + axis * vertices, values, first, before, frame, axis);
    }
    frames.push(frame);
  }
  return frames;
}

function decodeAxis(bytes, at, toHigh, first, before, frame, axis) {
  for (let strand = 0; strand + 1 < first.length; ++strand) {
    let change = 0;
    for (let v = first[strand]; v < first[strand + 1]; ++v) {
      const zigzag = bytes[at + v] | (bytes[at + v + toHigh] << 8);
      change += (zigzag >> 1) ^ -(zigzag & 1);
      frame[3 * v + axis] = before[3 * v + axis] + change;
    }
  }
}
