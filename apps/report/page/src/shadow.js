import {
  DepthTexture, FloatType, Matrix4, NearestFilter, OrthographicCamera, Vector3, WebGLRenderTarget,
} from 'three';

/** What is nearest to the light, seen from it; materials share the uniforms. */
export class Shadow {
  #camera = new OrthographicCamera();
  #target;
  uniforms = {
    lightDepth: { value: null },
    lightMatrix: { value: new Matrix4() },
    lightDirection: { value: new Vector3() },
    lightRange: { value: 1 },
  };

  constructor(size = 2048) {
    this.#target = new WebGLRenderTarget(size, size);
    this.#target.depthTexture = new DepthTexture(size, size, FloatType);
    this.#target.depthTexture.minFilter = this.#target.depthTexture.magFilter = NearestFilter;
    this.uniforms.lightDepth.value = this.#target.depthTexture;
  }

  /** Looks at a ball from a direction. */
  aim(centre, radius, towardsLight) {
    const camera = this.#camera;
    camera.left = camera.bottom = -radius;
    camera.right = camera.top = radius;
    camera.near = 0;
    camera.far = 2 * radius;
    camera.position.copy(towardsLight).multiplyScalar(radius).add(centre);
    camera.lookAt(centre);
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    this.uniforms.lightDirection.value.copy(towardsLight);
    this.uniforms.lightRange.value = 2 * radius;
    this.uniforms.lightMatrix.value
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  }

  /** Renders the meshes that have a userData.shadowMaterial. */
  render(renderer, scene) {
    const hidden = [], shown = [];
    scene.traverse((object) => {
      if (!object.isMesh || !object.visible) return;
      const material = object.userData.shadowMaterial;
      if (!material) {
        hidden.push(object);
        object.visible = false;
      } else {
        shown.push([object, object.material]);
        object.material = material;
      }
    });
    renderer.setRenderTarget(this.#target);
    renderer.clear();
    renderer.render(scene, this.#camera);
    renderer.setRenderTarget(null);
    for (const object of hidden) object.visible = true;
    for (const [object, material] of shown) object.material = material;
  }
}

/** GLSL: how much light comes through to a point of the world, 0 to 1. */
export const lightThrough = /* glsl */ `
uniform highp sampler2D lightDepth;
uniform mat4 lightMatrix;
uniform vec3 lightDirection;
uniform float lightRange;

// What lies between lets light through, less the more of it there is: hair is no wall.
float lightThrough(vec3 point, float bias, float thickness) {
  vec3 seen = (lightMatrix * vec4(point, 1.0)).xyz * 0.5 + 0.5;
  vec2 texel = 1.0 / vec2(textureSize(lightDepth, 0));
  float light = 0.0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      float nearest = texture(lightDepth, seen.xy + 1.5 * texel * vec2(i, j)).r;
      light += exp(-max(0.0, (seen.z - nearest) * lightRange - bias) / thickness);
    }
  }
  return light / 9.0;
}
`;
