import {
  BufferAttribute, BufferGeometry, DataTexture, DoubleSide, FloatType, GLSL3, LinearFilter, Mesh,
  RGBAFormat, ShaderMaterial, Vector2,
} from 'three';

import { scaleBytes } from './palette.js';
import { shadowFragment, strandFragment, strandVertex } from './strand_shader.js';

/** Steps of the ribbon along a segment: fewer where there are many segments. */
const stepsFor = (segments) => (segments > 400000 ? 1 : segments > 100000 ? 2 : 6);

/** Two triangles a step of each segment; a segment has the number of its first vertex. */
function ribbons(first, steps) {
  const strands = first.length - 1;
  const index = new Uint32Array(6 * steps * (first[strands] - strands));
  let at = 0;
  for (let strand = 0; strand < strands; ++strand) {
    for (let v = first[strand]; v + 1 < first[strand + 1]; ++v) {
      for (let step = 0; step < steps; ++step) {
        const corner = 2 * (v * (steps + 1) + step);
        index.set([corner, corner + 1, corner + 2, corner + 2, corner + 1, corner + 3], at);
        at += 6;
      }
    }
  }
  return index;
}

/** Radius, neighbours and a random number, as the shader takes them. */
function fillConstants(first, radii, constants) {
  for (let strand = 0; strand + 1 < first.length; ++strand) {
    // Golden ratio: neighbours differ, and no two are alike.
    const random = (strand * 0.6180339887) % 1;
    for (let v = first[strand]; v < first[strand + 1]; ++v) {
      const neighbours = (v > first[strand] ? 1 : 0) + (v + 2 < first[strand + 1] ? 2 : 0);
      constants.set([radii[v], neighbours, random], 4 * v);
    }
  }
}

/** Four numbers a vertex. */
function texelsFor(vertices) {
  const width = 1024;
  const height = Math.ceil(vertices / width);
  const texture = new DataTexture(new Float32Array(4 * width * height), width, height, RGBAFormat,
                                  FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** All strands. */
export class StrandMesh {
  /** One a vertex. */
  values;
  mesh;
  #moving;
  #uniforms;
  #steps;

  constructor(first, radii, shadowUniforms, size) {
    const vertices = first[first.length - 1];
    this.values = new Float32Array(vertices);
    this.#moving = texelsFor(vertices);
    const constant = texelsFor(vertices);
    fillConstants(first, radii, constant.image.data);
    this.#steps = stepsFor(vertices);
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(ribbons(first, this.#steps), 1));
    this.#uniforms = {
      ...shadowUniforms,
      moving: { value: this.#moving },
      constant: { value: constant },
      viewHeight: { value: 1 },
      widening: { value: 1 },
      scale: { value: null },
      range: { value: new Vector2(0, 1) },
      colouring: { value: 0 },
      thickness: { value: 0.025 * size },
      bias: { value: Math.max(0.002 * size, 1.5 * radii.reduce((a, b) => Math.max(a, b), 0)) },
    };
    this.mesh = new Mesh(geometry, this.#material(strandFragment, { alphaToCoverage: true }));
    this.mesh.userData.shadowMaterial = this.#material(shadowFragment, {});
    this.mesh.frustumCulled = false;
  }

  #material(fragmentShader, options) {
    return new ShaderMaterial({ glslVersion: GLSL3, uniforms: this.#uniforms, side: DoubleSide,
                                defines: { STEPS: this.#steps }, vertexShader: strandVertex,
                                fragmentShader, ...options });
  }

  /** x, y, z and a number more of each vertex. */
  get positions() {
    return this.#moving.image.data;
  }
  setHeight(pixels) {
    this.#uniforms.viewHeight.value = pixels;
  }
  setWidening(factor) {
    this.#uniforms.widening.value = factor;
  }
  positionsChanged() {
    this.#moving.needsUpdate = true;
  }
  valuesChanged() {
    const texels = this.#moving.image.data;
    this.values.forEach((value, v) => {
      texels[4 * v + 3] = value;
    });
    this.#moving.needsUpdate = true;
  }

  /** mode: hair, strand or a scale over a range. */
  setColouring(mode, stops, range) {
    this.#uniforms.colouring.value = mode === 'hair' ? 0 : mode === 'strand' ? 1 : 2;
    if (!stops) return;
    this.#uniforms.scale.value?.dispose();
    const texture = new DataTexture(scaleBytes(stops), 256, 1);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    this.#uniforms.scale.value = texture;
    if (range) this.#uniforms.range.value.set(...range);
  }
}
