import { Color, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { Shadow } from './shadow.js';

/** Where the light comes from, seen from the camera: over the left shoulder. */
const lightFromCamera = new Vector3(-0.55, 0.75, 0.6).normalize();

/** The canvas: camera, light and what is drawn. Draws only when something has changed. */
export class Stage {
  scene = new Scene();
  shadow = new Shadow();
  #renderer;
  #camera = new PerspectiveCamera(35);
  #controls;
  #ball;
  #wanted = false;
  #onResize = () => {};

  constructor(canvas, ball) {
    this.#ball = ball;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene.background = new Color('#17191d');
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => this.invalidate());
    this.frame();
    new ResizeObserver(() => this.#resize(canvas)).observe(canvas.parentElement);
  }

  /** Looks at everything, from the front. */
  frame() {
    const { centre, radius } = this.#ball;
    const distance = radius / Math.sin((this.#camera.fov * Math.PI) / 360);
    this.#camera.position.set(0.42, 0.22, 1).normalize().multiplyScalar(distance).add(centre);
    this.#camera.near = 0.01 * radius;
    this.#camera.far = 60 * radius;
    this.#controls.target.copy(centre);
    this.#controls.minDistance = 0.02 * radius;
    this.#controls.maxDistance = 20 * radius;
    this.#controls.update();
    this.#light();
    this.invalidate();
  }

  /** The light stays where the camera was. */
  #light() {
    const direction = lightFromCamera.clone().applyQuaternion(this.#camera.quaternion);
    this.shadow.aim(this.#ball.centre, 1.15 * this.#ball.radius, direction);
  }

  #resize(canvas) {
    const { clientWidth: width, clientHeight: height } = canvas.parentElement;
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    // On a tall canvas the width must hold what the height holds on a wide one.
    this.#camera.zoom = Math.min(1, width / height);
    this.#camera.updateProjectionMatrix();
    this.#onResize(this.#pixels());
    this.invalidate();
  }

  #pixels() {
    return this.#renderer.domElement.height;
  }

  /** Calls onResize(height in pixels), now and whenever it changes. */
  whenResized(onResize) {
    this.#onResize = onResize;
    onResize(this.#pixels());
  }

  invalidate() {
    if (this.#wanted) return;
    this.#wanted = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.#wanted = false;
    this.shadow.render(this.#renderer, this.scene);
    this.#renderer.render(this.scene, this.#camera);
  }
}
