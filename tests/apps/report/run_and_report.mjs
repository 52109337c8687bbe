// Makes a run and its report for the tests of the page.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const scene = {
  motions: { turn: [{ type: 'sinusoid', frequency: 1, angle: 0.5, axis: [0, 0, 1] }] },
  strands: { type: 'helix', count: 40, vertices: 31, curl_radius: 0.005, pitch: 0.005, pinned: 4,
             motion: 'turn', seed: 1, roots: { type: 'hemisphere', radius: 0.03 } },
  material: { youngs_modulus: 6e7, density: 65, radius: 2e-3 },
  forces: ['gravity'],
  collision: { type: 'fcl', thickness: 1e-3, stiffness: 2,
               colliders: [{ type: 'sphere', radius: 0.03, motion: 'turn' }] },
  run: { steps: 20, write: ['vtp'] },
};

/** Exit code of a test that CTest then counts as skipped. */
const skipped = 77;

function run(program, words) {
  const { status, stderr } = spawnSync(program, words, { encoding: 'utf8' });
  if (stderr.includes('built without the page')) {
    console.log(stderr);
    process.exit(skipped);
  }
  if (status !== 0) throw new Error(`${words.join(' ')}: exit code ${status}\n${stderr}`);
}

/** Calls test({folder, report}) with a run folder and its report; the folder is then removed. */
export async function withReport(program, test) {
  const place = mkdtempSync(join(tmpdir(), 'ringlet_report_'));
  try {
    const folder = join(place, 'out'), report = join(folder, 'report.html');
    writeFileSync(join(place, 'scene.json'), JSON.stringify(scene));
    run(program, ['run', join(place, 'scene.json'), '-o', folder, '--quiet']);
    run(program, ['report', folder]);
    await test({ folder, report, html: readFileSync(report, 'utf8') });
  } finally {
    rmSync(place, { recursive: true });
  }
}
