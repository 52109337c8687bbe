// Where labels go so that they cover neither each other nor a point.

/** Aslant first, where a line that falls to the right leaves room. */
const directions = [[-0.8, 0.6], [0.8, -0.6], [-0.8, -0.6], [0.8, 0.6], [-1, 0], [1, 0], [0, 1], [0, -1],
                    [0.45, -0.9], [-0.45, 0.9], [0.95, -0.3], [-0.95, 0.3]];
const distances = [9, 16, 24, 34, 46, 60, 76, 94];

const overlap = (a, b) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

const inside = (box, bounds) =>
  box.x >= bounds.x && box.y >= bounds.y && box.x + box.width <= bounds.x + bounds.width &&
  box.y + box.height <= bounds.y + bounds.height;

/** The box on the side of a point that a direction tells. */
function boxBeside({ x, y, width, height }, [right, down], distance) {
  const share = (along) => (along < -0.3 ? 1 : along > 0.3 ? 0 : 0.5);
  return { x: x + right * distance - share(right) * width,
           y: y + down * distance - share(down) * height, width, height };
}

/**
 * Boxes for the texts of some points, in their order; null where none is free.
 *
 * @param points {x, y, width, height}: the point and the size of its text
 * @param obstacles boxes that must stay free
 * @param bounds the box in which all must lie
 */
export function placeLabels(points, obstacles, bounds) {
  const taken = [...obstacles];
  return points.map((point) => {
    for (const distance of distances) {
      for (const direction of directions) {
        const box = boxBeside(point, direction, distance);
        if (!inside(box, bounds) || taken.some((other) => overlap(box, other))) continue;
        taken.push(box);
        return box;
      }
    }
    return null;
  });
}

/** Boxes along a line through some points, so that no label covers it. */
export function boxesAlong(points, size = 6) {
  const boxes = [];
  for (let i = 0; i + 1 < points.length; ++i) {
    const [from, to] = [points[i], points[i + 1]];
    const pieces = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / size));
    for (let piece = 0; piece <= pieces; ++piece) {
      boxes.push({ x: from.x + (piece / pieces) * (to.x - from.x) - size / 2,
                   y: from.y + (piece / pieces) * (to.y - from.y) - size / 2,
                   width: size, height: size });
    }
  }
  return boxes;
}
