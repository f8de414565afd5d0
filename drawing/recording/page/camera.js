/**
 * The camera: where it is, which way it looks, what it turns about. Its lens is that of our `View` (whole numbers are
 * the middles of pixels), scaled so that the view's whole picture fits into the window, in its middle.
 */
const NEAREST_TO_POLE = 0.01; // radians between the view and "up"

class Camera {
  constructor(described, bounds) {
    this.described = described;
    const [low, high] = bounds;
    this.corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));
    this.middle = scale(add(low, high), 0.5);
    this.reset();
    this.unit = length(subtract(high, low)) / 2 || this.pivotDepth() || 1;
    this.resize(described.width, described.height);
  }

  /** Back to the first view. */
  reset() {
    this.rotation = [...this.described.rotation];
    this.eye = [...this.described.eye];
    const forward = column(this.rotation, 2);
    const distance = length(subtract(this.middle, this.eye)) || 1;
    const depth = Math.max(dot(subtract(this.middle, this.eye), forward), 0.05 * distance);
    this.pivot = add(this.eye, scale(forward, depth));
    this.up = this.findUp();
  }

  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  /** The axis of the world that is upright in the picture; without one, the picture's own. */
  findUp() {
    const right = column(this.rotation, 0);
    const upward = scale(column(this.rotation, 1), -1);
    let best = upward;
    let most = 0.02;
    for (const axis of [[0, 0, 1], [0, 0, -1], [0, 1, 0], [0, -1, 0], [1, 0, 0], [-1, 0, 0]]) {
      if (Math.abs(dot(axis, right)) < 0.02 && dot(axis, upward) > most + 1e-9) [best, most] = [axis, dot(axis, upward)];
    }
    return best;
  }

  pivotDepth() {
    return dot(subtract(this.pivot, this.eye), column(this.rotation, 2));
  }

  /** The picture's scale and the focal lengths and middle in pixels of the window. */
  pixels() {
    const { width, height, fx, fy, cx, cy } = this.described;
    const s = Math.min(this.width / width, this.height / height);
    return { fx: fx * s, fy: fy * s, x: this.width / 2 + (cx + 0.5 - width / 2) * s, y: this.height / 2 + (cy + 0.5 - height / 2) * s };
  }

  /** What takes x, y (down) and z of the camera's frame to clip space. */
  lens() {
    const { fx, fy, x, y } = this.pixels();
    return [(2 * fx) / this.width, (-2 * fy) / this.height, (2 * x) / this.width - 1, 1 - (2 * y) / this.height];
  }

  /** Depths between which everything lies, or what of it the depth buffer can tell apart. */
  depthRange() {
    const forward = column(this.rotation, 2);
    const depths = this.corners.map((corner) => dot(subtract(corner, this.eye), forward));
    const slack = 1e-3 * this.unit;
    const far = Math.max(...depths) + slack;
    const least = Math.min(1e-3 * Math.max(far, this.pivotDepth()), 0.05 * this.pivotDepth());
    const near = Math.max(Math.min(...depths) - slack, least);
    return [near, Math.max(far, 2 * near)];
  }

  /** Where a place of the world is in the window: pixels from the left and top, and depth. */
  project(point) {
    const { fx, fy, x, y } = this.pixels();
    const from = subtract(point, this.eye);
    const [a, b, z] = [0, 1, 2].map((k) => dot(column(this.rotation, k), from));
    return [(fx * a) / z + x, (fy * b) / z + y, z];
  }

  /** The place of the world at a pixel and a depth. */
  unproject(px, py, depth) {
    const { fx, fy, x, y } = this.pixels();
    return add(this.eye, turn(this.rotation, [((px - x) / fx) * depth, ((py - y) / fy) * depth, depth]));
  }

  /** Turns about the pivot by angles to the right and down; "up" stays up. */
  orbit(right, down) {
    const forward = column(this.rotation, 2);
    const angle = Math.acos(clamp(dot(forward, this.up), -1, 1));
    const most = Math.max(0, angle - NEAREST_TO_POLE);
    const least = Math.min(0, angle - (Math.PI - NEAREST_TO_POLE));
    const pitch = rotationAbout(column(this.rotation, 0), clamp(-down, least, most));
    this.turnBy(multiply(rotationAbout(this.up, -right), pitch));
  }

  turnBy(rotation) {
    this.eye = add(this.pivot, turn(rotation, subtract(this.eye, this.pivot)));
    this.rotation = orthonormal(multiply(rotation, this.rotation));
  }

  /** Moves the picture by pixels, at the depth of the pivot. */
  pan(dx, dy) {
    const from = this.unproject(this.width / 2, this.height / 2, this.pivotDepth());
    const to = this.unproject(this.width / 2 + dx, this.height / 2 + dy, this.pivotDepth());
    this.eye = add(this.eye, subtract(from, to));
    this.pivot = add(this.pivot, subtract(from, to));
  }

  /** Nearer (a factor below 1) or farther; what is at the pixel stays there. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const depth = this.pivotDepth();
    const kept = clamp(depth * factor, 1e-6 * this.unit, 1e4 * this.unit) / depth;
    const place = this.unproject(px, py, depth);
    this.eye = add(place, scale(subtract(this.eye, place), kept));
    this.pivot = add(place, scale(subtract(this.pivot, place), kept));
  }

  /** Turns about another place from now on, which comes to the middle. */
  lookAt(place) {
    const forward = column(this.rotation, 2);
    const depth = Math.max(dot(subtract(place, this.eye), forward), 1e-6 * this.unit);
    const middle = this.unproject(this.width / 2, this.height / 2, depth);
    this.eye = add(this.eye, subtract(place, middle));
    this.pivot = place;
  }
}

/** A rotation without what rounding put into it. */
function orthonormal(m) {
  const x = scale(column(m, 0), 1 / length(column(m, 0)));
  const z0 = cross(x, column(m, 1));
  const z = scale(z0, 1 / length(z0));
  const y = cross(z, x);
  return [0, 1, 2].flatMap((k) => [x[k], y[k], z[k]]);
}
