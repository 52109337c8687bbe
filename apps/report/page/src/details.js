import { record } from './embedded.js';

const count = (number) => number.toLocaleString('en');
const one = (number) => +number.toPrecision(3);

function rows() {
  const { summary, scene, frames, strands } = record;
  const list = [['strands', `${count(strands.count)}, with ${count(strands.vertices)} vertices`]];
  list.push(['frames', `${count(frames.count)}, to ${one(frames.times.at(-1))} s`]);
  const { dt, type } = scene.integrator;
  list.push(['integrator', dt === undefined ? type : `${type}, a step is ${one(1000 * dt)} ms`]);
  const names = scene.energies.map((energy) => energy.type).join(', ');
  list.push(['energies', names || 'none']);
  if (!summary) return [['status', 'not finished: there is no summary.json'], ...list];
  return [
    ['status', summary.failure ? `${summary.status}: ${summary.failure}` : summary.status],
    ...list,
    ['steps', `${count(summary.steps)} of ${count(summary.steps_wanted)}, in ` +
              `${one(summary.wall_seconds)} s`],
    ['memory', `${one(summary.peak_memory_bytes / 1e6)} MB at most`],
    ['computed with', `ringlet ${summary.version}, ${summary.compiler}, ${summary.build_type}, ` +
                      `${summary.threads} threads`],
    ...(summary.processor ? [['machine', summary.processor]] : []),
  ];
}

/** Title, figures, what was left out, and the whole scene. */
export function showDetails() {
  const { scene, name, notes, summary } = record;
  document.title = `${name} – Ringlet`;
  document.getElementById('name').textContent = name;
  document.getElementById('about').textContent = scene.about ?? '';
  const list = document.getElementById('figures');
  for (const [label, value] of rows()) {
    const term = document.createElement('dt'), detail = document.createElement('dd');
    term.textContent = label;
    detail.textContent = value;
    list.append(term, detail);
  }
  document.getElementById('notes').replaceChildren(...notes.map((note) => {
    const item = document.createElement('li');
    item.textContent = note;
    return item;
  }));
  document.getElementById('scene').textContent = JSON.stringify(scene, null, 2);
  document.getElementById('summary').textContent =
    summary ? JSON.stringify(summary, null, 2) : 'There is no summary.json.';
}
