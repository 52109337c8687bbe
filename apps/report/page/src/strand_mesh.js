import {
  BufferAttribute, DataTexture, DoubleSide, DynamicDrawUsage, GLSL3, InstancedBufferAttribute,
  InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute, LinearFilter,
  Mesh, ShaderMaterial, Vector2,
} from 'three';

import { scaleBytes } from './palette.js';
import { shadowFragment, strandFragment, strandVertex } from './strand_shader.js';

/** Steps of the ribbon along a segment: fewer where there are many segments. */
const stepsFor = (segments) => (segments > 400000 ? 1 : segments > 100000 ? 2 : 6);

function ribbon(geometry, steps) {
  const corners = [], index = [];
  for (let step = 0; step <= steps; ++step) {
    corners.push(-1, step / steps, 1, step / steps);
    if (step < steps) {
      const at = 2 * step;
      index.push(at, at + 1, at + 2, at + 2, at + 1, at + 3);
    }
  }
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array(corners), 2));
  geometry.setIndex(index);
}

function describeSegments(first) {
  const vertices = first[first.length - 1];
  const segments = new Float32Array(2 * Math.max(vertices - 1, 1));
  for (let strand = 0; strand + 1 < first.length; ++strand) {
    // Golden ratio: neighbours differ, and no two are alike.
    const random = (strand * 0.6180339887) % 1;
    for (let v = first[strand]; v + 1 < first[strand + 1]; ++v) {
      segments[2 * v] = 1 + (v > first[strand] ? 2 : 0) + (v + 2 < first[strand + 1] ? 4 : 0);
      segments[2 * v + 1] = random;
    }
  }
  return segments;
}

/** All strands. A segment is an instance that sees its own two vertices and those beside them. */
export class StrandMesh {
  /** Of the vertices, one pad before and two behind: from `offset` on. */
  positions;
  offset = 3;
  values;
  mesh;
  #positionBuffer;
  #valueBuffer;
  #uniforms;

  constructor(first, radii, shadowUniforms, size) {
    const vertices = first[first.length - 1];
    const segments = Math.max(vertices - 1, 0);
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = segments;
    ribbon(geometry, stepsFor(segments));

    this.positions = new Float32Array(3 * (vertices + 3));
    this.#positionBuffer = this.#shared(geometry, this.positions, 3,
                                        { before: 0, from: 3, to: 6, after: 9 });
    this.values = new Float32Array(vertices);
    this.#valueBuffer = this.#shared(geometry, this.values, 1, { valueFrom: 0, valueTo: 1 });
    this.#shared(geometry, radii, 1, { radiusFrom: 0, radiusTo: 1 });
    geometry.setAttribute('segment', new InstancedBufferAttribute(describeSegments(first), 2));

    this.#uniforms = {
      ...shadowUniforms,
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
                                vertexShader: strandVertex, fragmentShader, ...options });
  }

  #shared(geometry, array, stride, offsets) {
    const buffer = new InstancedInterleavedBuffer(array, stride);
    buffer.setUsage(DynamicDrawUsage);
    for (const [name, offset] of Object.entries(offsets)) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, stride, offset));
    }
    return buffer;
  }

  setHeight(pixels) {
    this.#uniforms.viewHeight.value = pixels;
  }
  setWidening(factor) {
    this.#uniforms.widening.value = factor;
  }
  positionsChanged() {
    this.#positionBuffer.needsUpdate = true;
  }
  valuesChanged() {
    this.#valueBuffer.needsUpdate = true;
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
