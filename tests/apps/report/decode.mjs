// That the page decodes what the program embeds:  node decode.mjs RINGLET PAGE_SOURCES
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';

import { withReport } from './run_and_report.mjs';

const [program, sources] = process.argv.slice(2);
const { decodeFrames } = await import(pathToFileURL(join(sources, 'decode.js')));
const measures = await import(pathToFileURL(join(sources, 'measures.js')));

/** Points of a binary .vtp file. */
function readPoints(path) {
  const bytes = readFileSync(path);
  const head = bytes.subarray(0, bytes.indexOf('<AppendedData')).toString();
  const offset = Number(/Name="Points"[^>]*offset="(\d+)"/.exec(head)[1]);
  const begin = bytes.indexOf('_', head.length) + 1 + offset;
  const size = Number(bytes.readBigUInt64LE(begin));
  return new Float32Array(bytes.buffer.slice(begin + 8, begin + 8 + size));
}

await withReport(program, ({ folder, html }) => {
  const record = JSON.parse(/<script id="record"[^>]*>(.*?)<\/script>/s.exec(html)[1]);
  const { steps, low, step } = record.frames;
  const packets = [...html.matchAll(/<script class="frames"[^>]*>(.*?)<\/script>/gs)];
  assert.ok(packets.length > 1);
  const frames = packets.flatMap(([, text]) =>
    decodeFrames(inflateSync(Buffer.from(text, 'base64')), record.strands.first));
  assert.equal(frames.length, 21);
  frames.forEach((frame, number) => {
    const name = `frame_${String(steps[number]).padStart(5, '0')}.vtp`;
    const written = readPoints(join(folder, 'frames', name));
    assert.equal(frame.length, written.length);
    written.forEach((coordinate, i) => {
      const shown = low[i % 3] + step[i % 3] * frame[i];
      assert.ok(Math.abs(shown - coordinate) <= 0.5001 * step[i % 3], `${name}, number ${i}`);
    });
  });
});

/** A right-handed helix; all its vertices but the last have the same curvature and torsion. */
const turn = 0.3, radius = 0.01, rise = 0.002;
const helix = new Float32Array(60);
for (let v = 0; v < 20; ++v) {
  helix.set([radius * Math.cos(turn * v), radius * Math.sin(turn * v), rise * v], 3 * v);
}
const out = new Float32Array(20);
measures.curvature(helix, [0, 20], out);
const smooth = radius * turn ** 2 / ((radius * turn) ** 2 + rise ** 2);
out.forEach((value) => assert.ok(Math.abs(value / smooth - 1) < 0.02, `curvature ${value}`));
measures.torsion(helix, [0, 20], out);
const torsion = rise * turn / Math.hypot(radius * turn, rise) * 180 / Math.PI;
out.forEach((value) => assert.ok(Math.abs(value / torsion - 1) < 0.02, `torsion ${value}`));
measures.speed(helix, helix.map((x) => x + 0.5), 0.25, out);
out.forEach((value) => assert.ok(Math.abs(value - 2 * Math.sqrt(3)) < 1e-5, `speed ${value}`));
