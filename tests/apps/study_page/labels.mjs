// That labels cover neither each other nor points:  node labels.mjs PAGE_SOURCES
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [sources] = process.argv.slice(2);
const { boxesAlong, placeLabels } = await import(pathToFileURL(join(sources, 'labels.js')));

const bounds = { x: 0, y: 0, width: 800, height: 500 };
const overlap = (a, b) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** A front: upright first, then flat. */
const points = Array.from({ length: 25 }, (_, i) => (
  { x: 40 + 28 * i, y: 480 - 460 / (1 + 0.2 * i), width: 150, height: 15 }));
const dots = points.map(({ x, y }) => ({ x: x - 6, y: y - 6, width: 12, height: 12 }));
const obstacles = [...dots, ...boxesAlong(points)];
const boxes = placeLabels(points, obstacles, bounds);
const placed = boxes.filter((box) => box !== null);
assert.equal(boxes.length, points.length);
assert.ok(placed.length >= 12, `${placed.length} labels have found a place`);
placed.forEach((box, i) => {
  assert.ok(!placed.some((other, j) => i !== j && overlap(box, other)));
  assert.ok(!obstacles.some((other) => overlap(box, other)));
  assert.ok(box.x >= 0 && box.x + box.width <= 800 && box.y >= 0 && box.y + box.height <= 500);
});

assert.deepEqual(placeLabels([{ x: 5, y: 5, width: 900, height: 15 }], [], bounds), [null]);
