// Show the runs of a shake in 3D, in one pane each with the same camera.

import {
  BoxGeometry,
  Color,
  DirectionalLight,
  EdgesGeometry,
  GridHelper,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Quaternion,
  Scene,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from "three";

import { Robot } from "./robot.js";

const TCP = "fr3_hand_tcp";
const DEG = Math.PI / 180;
const CUBE_RGB = [
  [0.87, 0.37, 0.08],
  [0.1, 0.45, 0.82],
];
// Target [m], distance [m] and direction [°] of the camera, which moves with the hand or stands still.
const VIEWS = {
  arm: { rides: false, target: [-0.22, -0.45, 0.32], distance: 1.8, azimuth: -45, elevation: 16 },
  pads: { rides: true, target: [0, 0, -0.006], distance: 0.22, azimuth: -58, elevation: 12 },
  along: { rides: true, target: [0, 0, 0], distance: 0.26, azimuth: 180, elevation: 4 },
};
const FIELD_DEG = 30;
const NEAREST_M = 0.12;
const FARTHEST_M = 4;
const AT_REST = 2; // width of a pixel of the page in pixels of the canvas, while nothing moves
const SLOW_MS = 30; // if frames take longer than this on average during playback, there are fewer pixels
const FAST_MS = 18; // if they take less than this, there are more pixels again
const FEWEST = 0.6;
const FRAME_COUNT = 8;

class Pane {
  constructor(edge, number) {
    this.scene = new Scene();
    this.world = new Group(); // all objects move if the camera moves with the hand
    this.scene.add(this.world, new HemisphereLight(0xffffff, 0x8a8f96, 1.9));
    const sun = new DirectionalLight(0xffffff, 2.0);
    sun.position.set(0.42, -0.7, 0.9);
    this.scene.add(sun);
    const box = new BoxGeometry(edge, edge, edge);
    this.cube = new Mesh(box, new MeshLambertMaterial({ color: new Color().setRGB(...CUBE_RGB[number], SRGBColorSpace) }));
    this.start = new LineSegments(new EdgesGeometry(box), new LineBasicMaterial());
    this.start.scale.setScalar(1.004);
    this.grid = new GridHelper(4, 20);
    this.grid.rotation.x = Math.PI / 2;
    this.world.add(this.cube, this.start, this.grid);
  }

  place(robot, run, state, magnified, time) {
    robot.move(state.joints);
    this.world.add(robot.root);
    const tcp = robot.links[TCP];
    robot.root.updateWorldMatrix(false, true);
    const pose = tcp.matrixWorld.clone().premultiply(this.world.matrixWorld.clone().invert());
    const turn = new Quaternion().setFromRotationMatrix(pose);
    const begin = new Vector3(...run.begin.position);
    const put = (object, position, quaternion) => {
      object.position.copy(position).applyMatrix4(pose);
      object.quaternion.copy(turn).multiply(new Quaternion(...quaternion).normalize());
    };
    const position = new Vector3(...state.position);
    if (time >= 0 && run.inGrasp(time)) position.sub(begin).multiplyScalar(magnified).add(begin);
    put(this.cube, position, state.quaternion);
    put(this.start, begin, run.begin.quaternion);
    this.start.visible = time >= 0;
    this.hand = new Vector3().setFromMatrixPosition(pose);
  }
}

export class Stage {
  constructor(canvas, scene, redraw) {
    this.canvas = canvas;
    this.redraw = redraw;
    this.renderer = new WebGLRenderer({ canvas, antialias: false });
    this.renderer.setScissorTest(true);
    this.camera = new PerspectiveCamera(FIELD_DEG, 1, 0.02, 20);
    this.camera.up.set(0, 0, 1);
    this.panes = [0, 1].map((number) => new Pane(scene.edge_m, number));
    this.robots = this.panes.map(() => new Robot(scene.base_m));
    this.pixels = Math.min(window.devicePixelRatio, AT_REST);
    this.frames_ms = [];
    this.look("pads");
    this.#listen();
    new ResizeObserver(() => this.redraw()).observe(canvas.parentElement);
  }

  look(name) {
    this.view = { ...VIEWS[name] };
    this.redraw();
  }

  // Colours of the page: the background, the lines on the ground, and the edges at the cube's first position.
  colour({ back, lines, edges }) {
    this.back = new Color(back);
    for (const pane of this.panes) {
      pane.grid.material.vertexColors = false;
      pane.grid.material.color = new Color(lines);
      pane.grid.material.needsUpdate = true;
      pane.start.material.color = new Color(edges);
    }
  }

  // Without a graphics card, the pixels take most of the time. A frame that took `frame_ms` may reduce their number.
  draw(runs, states, magnified, time, frame_ms) {
    if (frame_ms) this.#measure(frame_ms);
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    this.#size(width, height, frame_ms ? this.pixels : AT_REST);
    const share = width / runs.length;
    this.camera.aspect = share / height;
    // A narrow pane shows as much to the sides as a square one.
    this.camera.fov = this.camera.aspect < 1 ? 2 * Math.atan(Math.tan((FIELD_DEG / 2) * DEG) / this.camera.aspect) / DEG : FIELD_DEG;
    this.camera.updateProjectionMatrix();
    const { target, distance, azimuth, elevation, rides } = this.view;
    const middle = new Vector3(...target);
    const [sideways, upwards] = [azimuth * DEG, elevation * DEG];
    this.camera.position
      .set(Math.cos(upwards) * Math.cos(sideways), Math.cos(upwards) * Math.sin(sideways), Math.sin(upwards))
      .multiplyScalar(distance)
      .add(middle);
    this.camera.lookAt(middle);
    runs.forEach((run, number) => {
      const pane = this.panes[number];
      pane.world.position.set(0, 0, 0);
      pane.world.updateMatrixWorld();
      pane.place(this.robots[number], run, states[number], magnified, time);
      if (rides) pane.world.position.copy(pane.hand).negate();
      pane.scene.background = this.back;
      this.renderer.setViewport(number * share, 0, share, height);
      this.renderer.setScissor(number * share, 0, share, height);
      this.renderer.render(pane.scene, this.camera);
    });
  }

  // Set the size only if it changes, because this clears the canvas.
  #size(width, height, pixels) {
    const size = [width, height, pixels].join();
    if (size === this.size) return;
    this.size = size;
    this.renderer.setDrawingBufferSize(width, height, pixels);
  }

  #measure(frame_ms) {
    this.frames_ms.push(frame_ms);
    if (this.frames_ms.length < FRAME_COUNT) return;
    const mean = this.frames_ms.reduce((sum, value) => sum + value) / FRAME_COUNT;
    if (mean > SLOW_MS) this.pixels = Math.max(0.8 * this.pixels, FEWEST);
    if (mean < FAST_MS) this.pixels = Math.min(1.25 * this.pixels, window.devicePixelRatio, AT_REST);
    this.frames_ms = [];
  }

  turn(sideways, upwards, closer) {
    const { view } = this;
    view.azimuth -= sideways;
    view.elevation = Math.min(Math.max(view.elevation + upwards, -20), 85);
    view.distance = Math.min(Math.max(view.distance * closer, NEAREST_M), FARTHEST_M);
    this.redraw();
  }

  #listen() {
    const fingers = new Map();
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, event);
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      const other = [...fingers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
      fingers.set(event.pointerId, event);
      if (other) {
        const apart = (a) => Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY);
        this.turn(0, 0, apart(before) / Math.max(apart(event), 1));
      } else this.turn(0.4 * (event.clientX - before.clientX), 0.4 * (event.clientY - before.clientY), 1);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-5, 0, 1], ArrowRight: [5, 0, 1], ArrowUp: [0, 5, 1], ArrowDown: [0, -5, 1], "+": [0, 0, 0.9], "-": [0, 0, 1.1] }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      this.turn(...step);
    });
  }
}
