/**
 * Camera of one view in float64: position, rotation, pivot. `rotation` is camera (x right, y down, z forward) to scene.
 * The lens is a vertical angle, or that of a `View` (integers are pixel centers), scaled so that the View's image fits
 * into the center. Pixels are those of the canvas; `box` is the view's part of it.
 */
const NEAREST_TO_POLE = 0.01; // [rad] minimum angle between the view and "up"
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

class Camera {
  constructor(margin = 0.5) {
    this.margin = margin; // relative margin of the scene's size: geometries move before new bounds arrive
    this.rotation = [1, 0, 0, 0, 0, -1, 0, 1, 0]; // along y, z up
    [this.eye, this.pivot, this.up] = [[0, -3, 0], [0, 0, 0], [0, 0, 1]];
    this.fov = 0.7;
    this.lensOfView = null;
    this.orthographic = false;
    this.limits = {};
    this.box = { x: 0, y: 0, width: 1, height: 1 };
    this.setBounds([-1, -1, -1], [1, 1, 1]);
    this.bounded = false;
  }

  setBounds(low, high) {
    if (![...low, ...high].every(Number.isFinite)) return;
    this.bounded = true;
    this.bounds = [low, high];
    this.corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));
    this.middle = scale(add(low, high), 0.5);
    this.radius = length(subtract(high, low)) / 2;
  }

  /** Size of the scene: positions are drawn in this unit, so that scenes of any size suit float32. */
  get unit() {
    return this.radius || this.pivotDepth() || 1;
  }

  /** Sets any of position, rotation, fov, lens, pivot, up, orthographic, near, far, closest, farthest. */
  set({ position, rotation, fov, lens, pivot, up, orthographic, near, far, closest, farthest }) {
    const moved = position || rotation;
    const depth = this.pivotDepth();
    if (position) this.eye = Array.from(position);
    if (rotation) this.rotation = orthonormal(Array.from(rotation));
    if (lens) this.lensOfView = lens;
    if (fov) [this.fov, this.lensOfView] = [fov, null];
    if (orthographic !== undefined) this.orthographic = Boolean(orthographic);
    for (const [name, value] of Object.entries({ near, far, closest, farthest })) if (value > 0) this.limits[name] = value;
    if (up && length(up) > 0) this.up = scale(up, 1 / length(up));
    else if (rotation && Math.abs(dot(this.up, column(this.rotation, 0))) > 0.02) this.up = this.findUp();
    if (pivot) this.pivot = this.onAxis(dot(subtract(pivot, this.eye), column(this.rotation, 2)), pivot);
    else if (moved) this.pivot = this.onAxis(depth);
  }

  /** Pivot: `target` if it is in front of the camera, else a point on its axis. */
  onAxis(depth, target = null) {
    if (target && depth > 0) return Array.from(target);
    return add(this.eye, scale(column(this.rotation, 2), Math.max(depth, 1e-6 * (this.radius || 1))));
  }

  /** Sets the pivot to the point on the axis at the depth of the scene's center. */
  aimAtMiddle() {
    const from = subtract(this.middle, this.eye);
    const distance = length(from) || 1;
    this.pivot = this.onAxis(Math.max(dot(from, column(this.rotation, 2)), 0.05 * distance));
    this.up = this.findUp();
  }

  state() {
    const { rotation, eye, pivot, up, fov, lensOfView, orthographic } = this;
    return { rotation: [...rotation], eye: [...eye], pivot: [...pivot], up: [...up], fov, lensOfView, orthographic };
  }

  describe() {
    const { rotation, eye, pivot, up, orthographic, box } = this;
    const fov = 2 * Math.atan(box.height / 2 / this.pixels().fy);
    const size = [Math.max(1, Math.round(box.width)), Math.max(1, Math.round(box.height))];
    return { position: [...eye], rotation: [...rotation], fov, pivot: [...pivot], up: [...up], orthographic, size };
  }

  /** The upright world axis; if none, that of the image. */
  findUp() {
    const right = column(this.rotation, 0);
    const imageUp = scale(column(this.rotation, 1), -1);
    let best = imageUp;
    let bestCosine = 0.02;
    for (const axis of [[0, 0, 1], [0, 0, -1], [0, 1, 0], [0, -1, 0], [1, 0, 0], [-1, 0, 0]]) {
      if (Math.abs(dot(axis, right)) < 0.02 && dot(axis, imageUp) > bestCosine + 1e-9) {
        [best, bestCosine] = [axis, dot(axis, imageUp)];
      }
    }
    return best;
  }

  pivotDepth() {
    return dot(subtract(this.pivot, this.eye), column(this.rotation, 2));
  }

  /** Focal lengths and principal point [px] of the canvas. */
  pixels() {
    const { x, y, width: w, height: h } = this.box;
    if (this.lensOfView === null) {
      const f = h / 2 / Math.tan(this.fov / 2);
      return { fx: f, fy: f, x: x + w / 2, y: y + h / 2 };
    }
    const { width, height, fx, fy, cx, cy } = this.lensOfView;
    const s = Math.min(w / width, h / height);
    return { fx: fx * s, fy: fy * s, x: x + w / 2 + (cx + 0.5 - width / 2) * s, y: y + h / 2 + (cy + 0.5 - height / 2) * s };
  }

  /** Projection from camera coordinates in units of the scene to clip space. */
  lens() {
    const { fx, fy, x, y } = this.pixels();
    const { box } = this;
    const s = this.orthographic ? this.unit / this.pivotDepth() : 1;
    const [across, down] = [x - box.x, y - box.y];
    return [(2 * fx * s) / box.width, (-2 * fy * s) / box.height, (2 * across) / box.width - 1, 1 - (2 * down) / box.height];
  }

  /** Depth range of the scene, limited to what the depth buffer can resolve. */
  depthRange() {
    if (!this.bounded) return this.guessedRange();
    const forward = column(this.rotation, 2);
    const depths = this.corners.map((corner) => dot(subtract(corner, this.eye), forward));
    const slack = Math.max(this.margin, 1e-3) * this.unit;
    if (this.orthographic) return [Math.min(...depths) - slack, Math.max(...depths) + slack];
    const far = Math.max(...depths) + 4 * slack; // far margin costs little precision
    const minNear = Math.min(1e-3 * Math.max(far, this.pivotDepth()), 0.05 * this.pivotDepth());
    const near = Math.max(Math.min(...depths) - slack, minNear);
    return [near, Math.max(far, 2 * near)];
  }

  /** Depth range for an unknown scene size. */
  guessedRange() {
    const { near = 1e-2 * this.pivotDepth(), far = 1e3 * this.pivotDepth() } = this.limits;
    return this.orthographic ? [-far, far] : [near, Math.max(far, 2 * near)];
  }

  /** Two factors from depth in units of the scene to the depth buffer. */
  depthFactors([near, far]) {
    if (this.orthographic) return [(2 * this.unit) / (far - near), -(far + near) / (far - near)];
    return [(far + near) / (far - near), (-2 * far * near) / (far - near) / this.unit];
  }

  /** Canvas position [px] and depth of a scene point. */
  project(point) {
    const { fx, fy, x, y } = this.pixels();
    const from = subtract(point, this.eye);
    const [a, b, z] = [0, 1, 2].map((k) => dot(column(this.rotation, k), from));
    const by = this.orthographic ? this.pivotDepth() : z;
    return [(fx * a) / by + x, (fy * b) / by + y, z];
  }

  /** Scene point of a pixel and a depth. */
  unproject(px, py, depth) {
    const { fx, fy, x, y } = this.pixels();
    const by = this.orthographic ? this.pivotDepth() : depth;
    return add(this.eye, rotate(this.rotation, [((px - x) / fx) * by, ((py - y) / fy) * by, depth]));
  }

  /** Rotates about the pivot by angles to the right and down; "up" stays upright. */
  orbit(right, down) {
    const forward = column(this.rotation, 2);
    const angle = Math.acos(clamp(dot(forward, this.up), -1, 1));
    const maxPitch = Math.max(0, angle - NEAREST_TO_POLE);
    const minPitch = Math.min(0, angle - (Math.PI - NEAREST_TO_POLE));
    const pitch = rotationAbout(column(this.rotation, 0), clamp(-down, minPitch, maxPitch));
    this.rotateBy(multiply(rotationAbout(this.up, -right), pitch));
  }

  rotateBy(rotation) {
    this.eye = add(this.pivot, rotate(rotation, subtract(this.eye, this.pivot)));
    this.rotation = orthonormal(multiply(rotation, this.rotation));
  }

  pan(dx, dy) {
    const { x, y } = this.pixels();
    const from = this.unproject(x, y, this.pivotDepth());
    this.shift(subtract(from, this.unproject(x + dx, y + dy, this.pivotDepth())));
  }

  shift(by) {
    this.eye = add(this.eye, by);
    this.pivot = add(this.pivot, by);
  }

  /** Zooms by a factor (below 1: closer); the point at the pixel is fixed. */
  zoom(factor, px = this.pixels().x, py = this.pixels().y) {
    const depth = this.pivotDepth();
    const { closest = 1e-6 * this.unit, farthest = 1e4 * this.unit } = this.limits;
    const ratio = clamp(depth * factor, Math.min(closest, depth), Math.max(farthest, depth)) / depth;
    const fixed = this.unproject(px, py, depth);
    this.eye = add(fixed, scale(subtract(this.eye, fixed), ratio));
    this.pivot = add(fixed, scale(subtract(this.pivot, fixed), ratio));
  }

  lookAt(point) {
    const depth = Math.max(dot(subtract(point, this.eye), column(this.rotation, 2)), 1e-6 * this.unit);
    const { x, y } = this.pixels();
    this.eye = add(this.eye, subtract(point, this.unproject(x, y, depth)));
    this.pivot = point;
  }

  /** Looks along an axis, "+x" to "-z", from the same distance. */
  lookAlong(axis) {
    this.face(scale(AXES[axis[1]], axis[0] === "-" ? -1 : 1));
  }

  /** Looks along a unit vector with "up" upright; along "up" itself, another axis is upright. */
  face(forward) {
    let up = this.up;
    if (Math.abs(dot(forward, up)) > 0.9999) {
      const along = dot(forward, this.up) > 0 ? 1 : -1;
      up = Math.abs(this.up[1]) > 0.9 ? [0, 0, along * Math.sign(this.up[1])] : [0, 1, 0];
    }
    const right = cross(forward, up);
    const x = scale(right, 1 / length(right));
    const y = cross(forward, x);
    const distance = length(subtract(this.pivot, this.eye));
    this.rotation = [0, 1, 2].flatMap((k) => [x[k], y[k], forward[k]]);
    this.eye = subtract(this.pivot, scale(forward, distance));
  }

  setUp(axis) {
    this.up = axis;
    this.face(scale(subtract(this.pivot, this.eye), 1 / length(subtract(this.pivot, this.eye))));
  }

  /** Tangent of half the smaller view angle. */
  halfTangent() {
    const { fx, fy } = this.pixels();
    return Math.min(this.box.width / fx, this.box.height / fy) / 2;
  }

  recede(factor) {
    this.eye = add(this.pivot, scale(subtract(this.eye, this.pivot), factor));
  }

  fit() {
    const half = this.halfTangent();
    const distance = ((this.radius || this.unit) * 1.05) / (this.orthographic ? half : Math.sin(Math.atan(half)));
    this.pivot = this.middle;
    this.eye = subtract(this.middle, scale(column(this.rotation, 2), distance));
  }
}

/** Removes rounding errors from a rotation. */
function orthonormal(m) {
  const x = scale(column(m, 0), 1 / length(column(m, 0)));
  const z0 = cross(x, column(m, 1));
  const z = scale(z0, 1 / length(z0));
  const y = cross(z, x);
  return [0, 1, 2].flatMap((k) => [x[k], y[k], z[k]]);
}
