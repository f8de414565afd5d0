/**
 * A recording as nodes of the engine. A shape is uploaded when a frame first shows it; frames are nodes that share
 * arrays. Beyond a budget, the least recently shown shapes are freed and uploaded again when needed; two consecutive
 * frames may exceed it.
 */
const MEMORY_BUDGET = 2 ** 30; // bytes on the GPU

class Recorded {
  constructor(engine, description, arrays) {
    Object.assign(this, { engine, description, arrays });
    this.placements = description.placements.map(([item, shapes, pose]) => ({ item, shapes, pose }));
    this.hidden = new Set(); // hidden items
    this.used = new Map(); // time of last use of each uploaded shape
    this.clock = 0;
    this.sending = Promise.resolve();
    this.shown = [];
  }

  async readPoses() {
    this.poses = await this.arrays.read(this.description.poses);
  }

  /** Uploads missing shapes of these placements; resolves when done. */
  send(placements) {
    this.sending = this.sending.catch(() => {}).then(() => this.sendAll(placements)); // one after the other
    return this.sending;
  }

  async sendAll(placements) {
    this.clock += 1;
    for (const number of new Set(placements.flatMap((placement) => this.placements[placement].shapes))) {
      if (!this.engine.has(nameOf(number))) await this.sendShape(number);
      this.used.set(number, this.clock);
    }
    this.free();
  }

  async sendShape(number) {
    const { kind, positions, normals, colors, indices } = this.description.shapes[number];
    const read = (array) => (array === undefined ? null : this.arrays.read(array));
    const [points, directions, paints, corners] = await Promise.all([positions, normals, colors, indices].map(read));
    const shape = { positions: points, normals: directions, colors: paints, indices: corners };
    const sent = kind === "lines" ? { positions: segments(points, corners), colors: paints } : shape;
    this.engine.add(nameOf(number), 0, kind, { visible: false, keep: false }, sent); // the page itself keeps them
  }

  /** Frees shapes that neither this nor the last call needed, least recently used first, down to the budget. */
  free() {
    const unused = [...this.used].filter(([, when]) => when < this.clock - 1).sort((a, b) => a[1] - b[1]);
    for (const [number] of unused) {
      if (this.engine.statistics().bytes <= MEMORY_BUDGET) return;
      this.engine.drop(nameOf(number));
      this.used.delete(number);
    }
  }

  show(placements) {
    const { engine } = this;
    for (const { id } of this.shown) engine.drop(id);
    this.shown = [];
    for (const number of placements) {
      const { item, shapes, pose } = this.placements[number];
      for (const shape of shapes) {
        const id = `${number} of ${this.shown.length}`;
        const placement = { pose: this.poseOf(pose), visible: !this.hidden.has(item) };
        if (engine.has(nameOf(shape))) engine.add(id, 0, "group", { ...this.looksOf(shape), ...placement });
        this.shown.push({ id, item });
      }
    }
  }

  poseOf(number) {
    return this.poses.subarray(12 * number, 12 * number + 12);
  }

  looksOf(number) {
    const { size, plain, wireframe, cull, unlit } = this.description.shapes[number];
    return { of: nameOf(number), size, width: size, plain, wireframe, cull, lit: !unlit };
  }

  hide(item, hidden) {
    this.hidden[hidden ? "add" : "delete"](item);
    for (const shown of this.shown) if (shown.item === item) this.engine.set(shown.id, { visible: !hidden });
  }
}

function nameOf(shape) {
  return `shape ${shape}`;
}

/** Both ends of each segment. */
function segments(positions, indices) {
  const ends = new Float32Array(3 * indices.length);
  for (let i = 0; i < indices.length; i++) {
    for (let k = 0; k < 3; k++) ends[3 * i + k] = positions[3 * indices[i] + k];
  }
  return ends;
}
