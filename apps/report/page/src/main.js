import { Vector3 } from 'three';
import 'uplot/dist/uPlot.min.css';

import { ColliderMeshes } from './collider_meshes.js';
import { colourings, Values } from './colouring.js';
import { showDetails } from './details.js';
import { record, unpackFloats } from './embedded.js';
import { Frames } from './frames.js';
import { gradient } from './palette.js';
import { Player } from './player.js';
import { drawPlots } from './plots.js';
import { Stage } from './stage.js';
import { StrandMesh } from './strand_mesh.js';
import './style.css';

const element = (id) => document.getElementById(id);

/** The ball around all positions of the run. */
const ballOf = ({ centre, radius }) => ({ centre: new Vector3(...centre), radius });

/** Everything that is seen, as it is at the player's time. */
class View {
  #stage;
  #strands;
  #colliders = new ColliderMeshes();
  #frames;
  #values;
  #colouring = 'hair';
  #measured;

  constructor(stage, frames, radii, ball) {
    this.#stage = stage;
    this.#frames = frames;
    this.#values = new Values(frames);
    this.#strands = new StrandMesh(frames.first, radii, stage.shadow.uniforms, ball.radius);
    stage.whenResized((height) => this.#strands.setHeight(height));
    stage.scene.add(this.#strands.mesh, this.#colliders.group);
  }

  loadColliders(ball) {
    return this.#colliders.load(record.colliders, ball, this.#stage.shadow.uniforms,
                                [0.42, 0.26, 0.18]);
  }

  show(frame, fraction) {
    if (frame >= this.#frames.ready) return;
    this.#frames.positionsAt(frame, fraction, this.#strands.positions, 4);
    this.#strands.positionsChanged();
    this.#colliders.place(frame, fraction);
    this.#measure(frame);
    this.#stage.invalidate();
  }

  #measure(frame) {
    if (this.#colouring === 'hair' || this.#colouring === 'strand') return;
    if (this.#measured === `${this.#colouring} ${frame} ${this.#frames.ready}`) return;
    this.#measured = `${this.#colouring} ${frame} ${this.#frames.ready}`;
    this.#values.measure(this.#colouring, frame, this.#strands.values);
    this.#strands.valuesChanged();
  }

  /** Returns the scale, stops and range, if there is one. */
  colourBy(name, frame) {
    this.#colouring = name;
    const { stops, unit } = colourings[name];
    const scale = unit ? this.#values.scale(name) : undefined;
    this.#strands.setColouring(name, scale?.stops ?? stops, scale?.range);
    this.#measure(frame);
    this.#stage.invalidate();
    return scale;
  }

  widen(factor) {
    this.#strands.setWidening(factor);
    this.#stage.invalidate();
  }
}

function showLegend(name, scale) {
  element('legend').hidden = !scale;
  if (!scale) return;
  const [low, high] = scale.range.map((value) => String(+value.toPrecision(3)));
  element('scale').style.background = gradient(scale.stops);
  element('low').textContent = low;
  element('high').textContent = `${high} ${colourings[name].unit}`;
}

function showPlace(player, frames) {
  element('play').textContent = player.playing ? '❚❚' : '▶';
  element('play').setAttribute('aria-label', player.playing ? 'pause' : 'play');
  element('slider').value = player.frame;
  element('frame').textContent = `${player.frame + 1} / ${frames.count}`;
  element('time').textContent = `step ${frames.steps[player.frame]} · ${player.time.toFixed(3)} s`;
}

function listenToKeys(player, frames) {
  const actions = {
    ' ': () => player.toggle(),
    ArrowLeft: () => player.step(-1),
    ArrowRight: () => player.step(1),
    Home: () => player.show(0),
    End: () => player.show(frames.count - 1),
  };
  document.addEventListener('keydown', (event) => {
    const typing = event.target.closest('select, summary, a');
    if (typing || event.ctrlKey || event.metaKey || event.altKey || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  });
}

function connectControls(player, view, stage, frames) {
  element('play').addEventListener('click', (event) => {
    event.currentTarget.blur();
    player.toggle();
  });
  element('slider').max = frames.count - 1;
  element('slider').addEventListener('input', (event) => {
    player.playing = false;
    player.show(Number(event.target.value));
  });
  element('rate').addEventListener('change', (event) => {
    player.rate = Number(event.target.value);
  });
  element('width').addEventListener('change', (event) => view.widen(Number(event.target.value)));
  element('reset').addEventListener('click', () => stage.frame());
  for (const [name, { label }] of Object.entries(colourings)) {
    element('colour').add(new Option(label, name));
  }
  element('colour').addEventListener('change', (event) => {
    showLegend(event.target.value, view.colourBy(event.target.value, player.frame));
  });
  listenToKeys(player, frames);
}

async function main() {
  showDetails();
  const frames = new Frames();
  const ball = ballOf(record.frames);
  const stage = new Stage(element('canvas'), ball);
  const view = new View(stage, frames, await unpackFloats(record.strands.radii), ball);
  await view.loadColliders(ball);
  let markTime = () => {};
  const player = new Player(frames, () => {
    view.show(player.frame, player.fraction);
    showPlace(player, frames);
    markTime(player.time);
  });
  connectControls(player, view, stage, frames);
  markTime = drawPlots(element('plots'), (time) => player.showTime(time));

  await frames.load(() => {
    element('loading').textContent = `loading ${frames.ready} of ${frames.count} frames`;
    if (!player.playing) player.show(player.frame);
  });
  element('loading').hidden = true;
  const colour = element('colour').value;
  showLegend(colour, view.colourBy(colour, player.frame));
  document.body.dataset.loaded = 'yes';
}

main().catch((error) => {
  element('loading').hidden = false;
  element('loading').textContent = `This page cannot be shown: ${error.message}`;
  throw error;
});
