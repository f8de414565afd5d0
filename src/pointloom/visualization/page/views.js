/**
 * One, two or four views of the scene on one canvas. Linked views share the pivot: a move applies to all, each from its
 * own side.
 */
const GAP = 2; // [CSS px] between views

class Views {
  constructor(margin) {
    this.margin = margin;
    this.cameras = [new Camera(margin)];
    this.linked = true;
    this.active = 0;
    [this.width, this.height] = [1, 1];
  }

  get camera() {
    return this.cameras[this.active];
  }

  /** Sets the number of views: the first is kept, the others look from its sides and above at the same scale. */
  set(count, linked) {
    const first = this.camera;
    const halfTangent = first.halfTangent();
    this.linked = linked;
    this.active = 0;
    this.cameras = [first];
    for (let k = 1; k < count; k++) {
      const camera = new Camera(this.margin);
      camera.setBounds(...first.bounds);
      Object.assign(camera, first.state(), { limits: first.limits, bounded: first.bounded });
      this.cameras.push(camera);
    }
    if (count === 2) this.cameras[1].orbit(Math.PI / 2, 0);
    if (count === 4) {
      const sides = [scale(first.up, -1), ...["y", "x", "z"].map((axis) => AXES[axis])];
      const others = sides.slice(1).filter((axis) => Math.abs(dot(axis, first.up)) < 0.9);
      this.cameras[1].face(sides[0]);
      this.cameras[2].face(others[0]);
      this.cameras[3].face(scale(others[1], -1));
    }
    this.resize(this.width, this.height);
    for (const camera of this.cameras) camera.recede(halfTangent / camera.halfTangent());
  }

  resize(width, height) {
    Object.assign(this, { width, height });
    const { length: count } = this.cameras;
    const [columns, rows] = count === 4 ? [2, 2] : count === 2 ? (width >= height ? [2, 1] : [1, 2]) : [1, 1];
    const [w, h] = [(width - GAP * (columns - 1)) / columns, (height - GAP * (rows - 1)) / rows];
    this.cameras.forEach((camera, k) => {
      const [column, row] = [k % columns, Math.floor(k / columns)];
      camera.box = { x: column * (w + GAP), y: row * (h + GAP), width: Math.max(1, w), height: Math.max(1, h) };
    });
  }

  at(x, y) {
    const inside = ({ box }) => x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
    const index = this.cameras.findIndex(inside);
    return index < 0 ? this.active : index;
  }

  each(change) {
    this.cameras.forEach(change);
  }

  /** Moves the active view by a method of `Camera`; linked views follow. */
  move(name, ...values) {
    const { camera } = this;
    const [pivot, distance] = [camera.pivot, camera.pivotDepth()];
    camera[name](...values);
    if (!this.linked) return;
    const [by, ratio] = [subtract(camera.pivot, pivot), camera.pivotDepth() / distance];
    for (const other of this.cameras) {
      if (other === camera) continue;
      if (name === "orbit") other.orbit(...values);
      other.shift(by);
      other.recede(ratio);
    }
  }
}
