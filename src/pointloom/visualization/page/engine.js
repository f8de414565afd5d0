/**
 * The engine: a tree of nodes drawn by WebGL 2 on one canvas, with its camera, for recordings and live pages.
 *
 * new Engine(canvas, overlay, { onCamera, onClick, onLost, onDrawn, onAxes, gizmo, scaleBar, margin })
 *   canvas    fills its parent; overlay: an element over it for labels, gizmo and scale bar (only the gizmo takes events).
 *   onCamera(camera)               the active camera has changed; at most once per frame. As camera() returns it.
 *   onClick(shareX, shareY)        a press without motion, as fractions of the view's size; preceded by onCamera if it
 *                                  activated another view.
 *   onLost(ids)                    nodes dropped with a lost context, as their arrays were not kept (`keep: false`, or
 *                                  over budget): the host adds them again.
 *   onDrawn()                      an image is complete.
 *   gizmo, scaleBar                whether they are displayed (true).
 *   margin                         margin of the bounds for near and far, over the scene's size (0.5).
 *   Throws NoWebGL without WebGL 2.
 *
 * Nodes (ids are any keys except 0, the scene; poses are 12 numbers, rows of 3x4, node to parent)
 *   add(id, parent, kind, props, arrays)   kind: group, points, triangles, lines, label; replaces id.
 *     props: pose, visible, keep and those of the kind: plain [r,g,b 0..255], size, metric, relief, opacity, lit, cull,
 *     wireframe, width, text, anchor. `of: id` shares the other node's arrays.
 *     arrays: positions (Float32Array, or Uint16Array of half floats), colors (Uint8Array), normals (Int16Array),
 *     indices (Uint32Array), uvs (Float32Array), texture (Uint8Array: a PNG or JPEG). Uploaded and kept without a copy.
 *   set(id, props, arrays), drop(id) with its children, clear(), has(id). The parent defaults to the scene.
 *
 * Camera (rotation: rows of R_world_camera, x right, y down, z forward; see camera.js)
 *   setCamera({ position, rotation, fov, pivot, up, near, far, closest, farthest, orthographic }), any of them; the first
 *   call defines home(). camera() -> { position, rotation, fov, pivot, up, orthographic, size [w, h] }
 *   setHome(), home(), fit(), lookAlong("+x" ... "-z"), setUp("y" | "z" | [x, y, z]), setOrthographic(on), orbit(right, down)
 *   setViews(1 | 2 | 4, linked): side by side; linked ones move together.
 *   setBounds(low, high): defines near and far; before it, those of setCamera are used.
 *   setBackground([r, g, b 0..1], own): own false follows prefers-color-scheme. setUnit("m" | any text | null: no scale bar)
 *   commands(): [{ key, label, group, run }] for the host's keys ("O", "Shift+X", "Shift+ArrowUp") and palette.
 *
 * Images
 *   looks: { pointFactor, wireframe, normals, light 0..2 }; call redraw() after a change. settled() resolves when an image
 *   of all changes is complete, ready() when textures and layout are, too.
 *   pickDepth(x, y) -> depth [m] at a canvas position [CSS px], or null; pick(x, y) -> point or null;
 *   project(point) -> [x, y, depth]; unproject(x, y, depth); screenshot() -> Promise of a Blob (PNG) with labels;
 *   statistics() -> { draws, calls, uploads, bytes, kept, nodes, points, triangles, every, labels }
 */
const KEPT_MEMORY = 2 ** 28; // bytes of arrays kept for a lost context
const DARK_BACKGROUND = [0.106, 0.118, 0.137];
const MAX_PIXELS = 2; // maximum device pixel ratio: more is not visible
const KINDS = ["points", "triangles", "lines"];

class Engine {
  constructor(canvas, overlay, options = {}) {
    const { gizmo = true, scaleBar = true, margin = 0.5 } = options;
    Object.assign(this, { canvas, overlay, host: options, tree: new Tree(), geometries: new Set(), uploads: 0, draws: 0, kept: 0 });
    this.painter = new Painter(canvas);
    this.looks = { pointFactor: 1, wireframe: false, normals: false, light: 0 };
    this.background = { color: [1, 1, 1], own: true };
    this.views = new Views(margin);
    this.first = null;
    this.labels = new Labels(overlay);
    this.corners = new Corners(overlay, { gizmo, scaleBar, look: (axis, view) => this.lookAlong(axis, view) });
    this.pace = new Pace((every) => this.draw(every), () => this.painter.finished());
    this.controls = new Controls(canvas, {
      move: (name, ...values) => this.move(name, ...values),
      use: (x, y) => this.use(x, y),
      click: (x, y) => this.click(x, y),
      doubleClick: (x, y) => this.pivotAt(x, y),
    });
    this.listen();
    this.resize();
  }

  listen() {
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => this.restore());
    this.scheme = window.matchMedia("(prefers-color-scheme: dark)");
    this.scheme.addEventListener("change", () => this.paintBackground());
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(this.canvas.parentElement);
    this.paintBackground();
  }

  // Nodes

  add(id, parent, kind, props = {}, arrays = {}) {
    this.drop(id);
    const node = this.tree.add(id, parent, kind);
    const shared = props.of === undefined ? null : this.tree.get(props.of)?.geometry;
    if (shared) {
      node.geometry = shared;
      node.kind = shared.kind;
      shared.users += 1;
    } else if (KINDS.includes(kind)) {
      node.geometry = new Geometry(this.painter.gl, kind, props.keep !== false, () => this.redraw());
      this.geometries.add(node.geometry);
    } else if (kind === "label") {
      node.label = {};
    }
    this.set(id, props, shared ? {} : arrays);
  }

  set(id, props = {}, arrays = {}) {
    const node = this.tree.get(id);
    if (!node || id === 0) return;
    const { pose, visible, ...looks } = props;
    if (pose) node.setPose(pose);
    if (visible !== undefined) this.tree.show(node, Boolean(visible));
    Object.assign(node.props, looks);
    if (node.label) node.label = {};
    if (node.geometry && node.props.of === undefined) this.send(node.geometry, looks, arrays);
    this.redraw();
  }

  /** Changed arrays of a node; a plain color replaces colors. */
  send(geometry, { plain }, arrays) {
    const bytes = bytesOf(arrays);
    if (bytes > 0) this.uploads += 1;
    this.kept -= geometry.kept;
    if (plain && !arrays.colors) geometry.remove("colors");
    if (this.kept + geometry.kept + bytes > KEPT_MEMORY) geometry.letGo();
    if (bytes > 0 || geometry.uploads === 0) geometry.send(arrays);
    this.kept += geometry.kept;
  }

  has(id) {
    return this.tree.get(id) !== undefined;
  }

  drop(id) {
    for (const { geometry } of this.tree.drop(id)) {
      if (!geometry) continue;
      geometry.users -= 1;
      if (geometry.users === 0) {
        this.kept -= geometry.kept;
        geometry.free();
        this.geometries.delete(geometry);
      }
    }
    this.redraw();
  }

  clear() {
    for (const node of [...this.tree.root.children]) this.drop(node.id);
  }

  /** Restores a lost context; nodes without kept arrays are dropped and reported. */
  restore() {
    this.painter.start();
    for (const geometry of this.geometries) {
      geometry.forget();
      if (!geometry.keep) continue;
      geometry.start(this.painter.gl);
      geometry.send(geometry.arrays);
      this.uploads += 1;
    }
    const lost = [...this.tree.nodes.values()].filter(({ geometry }) => geometry && !geometry.keep).map(({ id }) => id);
    for (const id of lost) this.drop(id);
    this.host.onLost?.(lost);
    this.redraw();
  }

  // Camera and views

  setCamera(camera) {
    const follows = this.views.linked ? this.views.cameras : [this.views.camera];
    const { position, rotation, pivot, ...others } = camera;
    this.views.camera.set(camera);
    for (const other of follows) if (other !== this.views.camera) other.set(others);
    if (this.first === null && (position || rotation)) this.setHome();
    this.changed();
  }

  /** Stores the view for `home`. */
  setHome() {
    this.first = this.views.camera.state();
  }

  home() {
    if (this.first === null) return this.fit();
    const { linked, cameras } = this.views;
    this.views.set(1, linked);
    Object.assign(this.views.camera, structuredClone(this.first));
    return this.setViews(cameras.length, linked);
  }

  camera() {
    return this.views.camera.describe();
  }

  move(name, ...values) {
    this.views.move(name, ...values);
    this.changed();
  }

  orbit(right, down) {
    this.move("orbit", right, down);
  }

  fit() {
    this.move("fit");
  }

  lookAlong(axis, view = this.views.active) {
    this.views.active = view;
    this.move("lookAlong", axis);
  }

  setUp(axis) {
    const up = AXES[axis] ?? axis;
    this.views.each((camera) => camera.setUp(up));
    this.changed();
  }

  setOrthographic(on) {
    this.views.each((camera) => camera.set({ orthographic: on }));
    this.changed();
  }

  setViews(count, linked = true) {
    this.views.set(count, linked);
    this.changed();
  }

  setBounds(low, high) {
    this.views.each((camera) => camera.setBounds(Array.from(low), Array.from(high)));
    this.redraw();
  }

  setUnit(unit) {
    this.corners.unit = unit;
    this.redraw();
  }

  /** Activates the view at a canvas position. */
  use(x, y) {
    const view = this.views.at(x, y);
    if (view === this.views.active) return;
    this.views.active = view;
    this.changed();
  }

  click(x, y) {
    const { box } = this.views.camera;
    this.reportCamera();
    this.host.onClick?.((x - box.x) / box.width, (y - box.y) / box.height);
  }

  pivotAt(x, y) {
    this.use(x, y);
    const point = this.pick(x, y);
    if (point) this.move("lookAt", point);
  }

  changed() {
    this.moved = true;
    this.redraw();
  }

  reportCamera() {
    if (!this.moved) return;
    this.moved = false;
    this.host.onCamera?.(this.camera());
  }

  // Pictures

  setBackground(color, own = true) {
    this.background = { color, own };
    this.paintBackground();
  }

  paintBackground() {
    const { color, own } = this.background;
    const follows = !own && this.scheme.matches;
    this.shownBackground = follows ? DARK_BACKGROUND : color;
    this.dark = dot(this.shownBackground, [0.299, 0.587, 0.114]) < 0.5;
    this.overlay.dataset.theme = this.dark ? "dark" : "light";
    this.redraw();
  }

  resize() {
    const { width, height } = this.canvas.parentElement.getBoundingClientRect();
    const density = Math.min(window.devicePixelRatio || 1, MAX_PIXELS);
    this.views.resize(width, height);
    this.painter.resize(width, height, density);
    this.labels.resize(width, height, density);
    this.moved = true;
    this.pace.now();
  }

  redraw() {
    this.pace?.request();
  }

  settled() {
    return this.pace.atRest();
  }

  /** Resolves when the layout, all uploads and a complete image with them are done. */
  async ready() {
    await nextFrame();
    await nextFrame(); // element sizes are observed after the first
    await Promise.all([...this.geometries].map(({ texture }) => texture?.ready));
    await this.settled();
  }

  draw(every) {
    if (this.painter.gl.isContextLost()) return;
    const nodes = this.tree.visibleNodes();
    this.draws += 1;
    this.painter.draw(this.views, nodes, this.looks, this.shownBackground ?? this.background.color, every);
    this.labels.draw(nodes, this.views, this.dark);
    this.corners.draw(this.views);
    this.reportCamera();
    this.host.onDrawn?.();
  }

  pickDepth(x, y) {
    return this.painter.depthAt(x, y, this.views.at(x, y));
  }

  pick(x, y) {
    const depth = this.pickDepth(x, y);
    return depth === null ? null : this.views.cameras[this.views.at(x, y)].unproject(x, y, depth);
  }

  project(point) {
    return this.views.camera.project(point);
  }

  unproject(x, y, depth) {
    return this.views.camera.unproject(x, y, depth);
  }

  /** The current image as a PNG, with labels and scale bar, without gizmo. */
  screenshot() {
    const { canvas, painter } = this;
    this.draw(1);
    const copy = document.createElement("canvas");
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0); // at once: the browser may clear it after this task
    context.drawImage(this.labels.canvas, 0, 0);
    this.corners.paint(context, canvas, painter.density);
    return new Promise((resolve, reject) =>
      copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture is too large"))), "image/png"));
  }

  statistics() {
    let bytes = 0;
    for (const geometry of this.geometries) bytes += geometry.bytes;
    const { calls, points, triangles, every } = this.painter;
    const { draws, uploads, kept } = this;
    const nodes = this.tree.nodes.size - 1;
    return { draws, calls, uploads, bytes, kept, nodes, points, triangles, every, labels: this.labels.count };
  }

  commands() {
    return commandsOf(this);
  }

}

function nextFrame() {
  return new Promise((done) => requestAnimationFrame(done));
}

function bytesOf(arrays) {
  return Object.values(arrays).reduce((sum, values) => sum + (values?.byteLength ?? 0), 0);
}
