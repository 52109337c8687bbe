import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, DoubleSide, GLSL3, Group, Mesh,
  PlaneGeometry, Quaternion, ShaderMaterial, SphereGeometry, Vector3,
} from 'three';

import { unpackFloats, unpackIntegers } from './embedded.js';
import { lightThrough } from './shadow.js';

const vertexShader = /* glsl */ `
out vec3 world, worldNormal;
void main() {
  vec4 placed = modelMatrix * vec4(position, 1.0);
  world = placed.xyz;
  worldNormal = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * viewMatrix * placed;
}
`;

const fragmentShader = /* glsl */ `
in vec3 world, worldNormal;
uniform vec3 base;
uniform float thickness, bias;
${lightThrough}
out vec4 colour;
void main() {
  vec3 normal = normalize(worldNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  float facing = dot(normal, lightDirection);
  float through = lightThrough(world + normal * bias, bias, thickness);
  vec3 ambient = mix(vec3(0.26, 0.24, 0.23), vec3(0.42, 0.45, 0.52), 0.5 + 0.5 * normal.y);
  vec3 lit = base * (ambient * mix(0.55, 1.0, through) + 1.1 * through * max(facing, 0.0));
  colour = vec4(pow(clamp(lit, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
}
`;

const vector = (numbers) => new Vector3(...numbers);

async function meshGeometry(collider) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position',
                        new BufferAttribute(await unpackFloats(collider.vertices), 3));
  geometry.setIndex(new BufferAttribute(await unpackIntegers(collider.triangles), 1));
  geometry.computeVertexNormals();
  return geometry;
}

function capsuleGeometry({ from, to, radius }) {
  const axis = vector(to).sub(vector(from));
  const geometry = new CapsuleGeometry(radius, axis.length(), 16, 48);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0),
                                                               axis.normalize()));
  const centre = vector(from).add(vector(to)).multiplyScalar(0.5);
  return geometry.translate(centre.x, centre.y, centre.z);
}

/** Of a plane, the part beside the strands. */
function planeGeometry({ point, normal }, ball) {
  const direction = vector(normal).normalize();
  const at = ball.centre.clone();
  at.addScaledVector(direction, direction.dot(vector(point).sub(at)));
  const geometry = new PlaneGeometry(5 * ball.radius, 5 * ball.radius);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction));
  return geometry.translate(at.x, at.y, at.z);
}

async function geometryOf(collider, ball) {
  switch (collider.type) {
    case 'sphere':
      return new SphereGeometry(collider.radius, 96, 64).translate(...collider.centre);
    case 'capsule':
      return capsuleGeometry(collider);
    case 'box':
      return new BoxGeometry(...collider.size).translate(...collider.centre);
    case 'plane':
      return planeGeometry(collider, ball);
    default:
      return meshGeometry(collider);
  }
}

/** The colliders of the scene, where they are at a frame. */
export class ColliderMeshes {
  group = new Group();
  #poses = [];

  async load(colliders, ball, shadowUniforms, skin) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, side: DoubleSide,
      uniforms: { ...shadowUniforms, base: { value: vector(skin) },
                  thickness: { value: 0.06 * ball.radius }, bias: { value: 0.02 * ball.radius } },
    });
    const shadowMaterial = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, side: DoubleSide,
      fragmentShader: 'out vec4 colour;\nvoid main() { colour = vec4(1.0); }',
    });
    for (const collider of colliders) {
      const mesh = new Mesh(await geometryOf(collider, ball), material);
      mesh.userData.shadowMaterial = collider.type === 'plane' ? null : shadowMaterial;
      this.group.add(mesh);
      this.#poses.push(collider.poses);
    }
  }

  /** poses: x y z and a quaternion x y z w a frame. */
  place(frame, fraction) {
    this.group.children.forEach((mesh, i) => {
      const poses = this.#poses[i];
      const next = Math.min(frame + 1, poses.length - 1);
      const [a, b] = [poses[frame], poses[next]];
      mesh.position.set(a[0], a[1], a[2]).lerp(new Vector3(b[0], b[1], b[2]), fraction);
      mesh.quaternion.set(a[3], a[4], a[5], a[6])
        .slerp(new Quaternion(b[3], b[4], b[5], b[6]), fraction);
    });
  }
}
