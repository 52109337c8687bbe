// Quantities of the polylines, one value a vertex. x holds x, y, z a vertex.

function difference(x, from, to, out) {
  for (let axis = 0; axis < 3; ++axis) out[axis] = x[3 * to + axis] - x[3 * from + axis];
  return out;
}
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
function cross(a, b, out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
  return out;
}

function forEachStrand(first, act) {
  for (let strand = 0; strand + 1 < first.length; ++strand) act(first[strand], first[strand + 1]);
}

/** Turning angle over the mean length of the two edges, 1/m; at the ends that of the neighbour. */
export function curvature(x, first, out) {
  const e = [0, 0, 0], f = [0, 0, 0], n = [0, 0, 0];
  forEachStrand(first, (begin, end) => {
    for (let v = begin + 1; v + 1 < end; ++v) {
      difference(x, v - 1, v, e);
      difference(x, v, v + 1, f);
      const angle = Math.atan2(Math.sqrt(dot(cross(e, f, n), n)), dot(e, f));
      out[v] = (2 * angle) / (Math.sqrt(dot(e, e)) + Math.sqrt(dot(f, f)));
    }
    out[begin] = end - begin > 2 ? out[begin + 1] : 0;
    out[end - 1] = end - begin > 2 ? out[end - 2] : 0;
  });
}

/**
 * Torsion angle of the centreline in degrees: between the planes of the edges before and after an
 * edge, positive for a right-handed curl; at a vertex the one of the edge that begins there, near
 * the ends that of the neighbour.
 */
export function torsion(x, first, out) {
  const e = [0, 0, 0], f = [0, 0, 0], g = [0, 0, 0], m = [0, 0, 0], n = [0, 0, 0];
  forEachStrand(first, (begin, end) => {
    out.fill(0, begin, end);
    if (end - begin < 4) return;
    for (let v = begin + 1; v + 2 < end; ++v) {
      difference(x, v - 1, v, e);
      difference(x, v, v + 1, f);
      difference(x, v + 1, v + 2, g);
      cross(e, f, m);
      cross(f, g, n);
      const sine = Math.sqrt(dot(f, f)) * dot(e, n);
      out[v] = (Math.atan2(sine, dot(m, n)) * 180) / Math.PI;
    }
    out[begin] = out[begin + 1];
    out[end - 2] = out[end - 1] = out[end - 3];
  });
}

/** Distance of two states over the time between them, m/s. */
export function speed(before, after, seconds, out) {
  for (let v = 0; v < out.length; ++v) {
    const x = after[3 * v] - before[3 * v];
    const y = after[3 * v + 1] - before[3 * v + 1];
    const z = after[3 * v + 2] - before[3 * v + 2];
    out[v] = seconds > 0 ? Math.sqrt(x * x + y * y + z * z) / seconds : 0;
  }
}
