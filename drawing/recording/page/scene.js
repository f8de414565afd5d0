/**
 * The scene on the graphics card. A shape is sent when a frame first shows it and stays; a frame only says which are
 * drawn and where. Past a budget those that were not shown for longest are freed, and sent again when needed; the
 * budget is no limit for what two frames in a row need.
 */
const MEMORY_BUDGET = 2 ** 30; // bytes on the graphics card
const FEW = 15_000; // points: fewer take no time worth saving
const EDGE_SHADE = 0.12; // of a surface's own colour, as in our pictures
const PROBE = 9; // pixels a side of the square in which a place is looked for

class NoWebGL extends Error {}

class Scene {
  constructor(canvas, description, arrays) {
    this.canvas = canvas;
    this.description = description;
    this.arrays = arrays;
    this.placements = description.placements.map(([item, shapes, pose]) => ({ item, shapes, pose }));
    this.statistics = { uploads: 0, bytes: 0, draws: 0 };
    this.looks = { pointFactor: 1, wireframe: false, normals: false, light: 0, hidden: new Set() };
    this.gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: false });
    if (!this.gl) throw new NoWebGL();
    this.start();
  }

  /** What a new or restored context needs. */
  start() {
    const { gl } = this;
    this.shapes = new Map();
    this.statistics.bytes = 0;
    this.clock = 0;
    this.sending = Promise.resolve();
    this.programs = {
      points: new Program(gl, SOLID_VERTEX, POINT_FRAGMENT),
      triangles: new Program(gl, SOLID_VERTEX, FACE_FRAGMENT),
      lines: new Program(gl, LINE_VERTEX, LINE_FRAGMENT),
      relief: new Program(gl, WHOLE_VERTEX, RELIEF_FRAGMENT),
      probe: new Program(gl, WHOLE_VERTEX, PROBE_FRAGMENT),
    };
    this.target = null;
    this.samples = isSoftware(gl) ? 0 : Math.min(4, gl.getParameter(gl.MAX_SAMPLES));
    this.empty = gl.createVertexArray();
  }

  async readPoses() {
    this.poses = await this.arrays.read(this.description.poses);
  }

  /** Sends what these placements show and the card does not hold; resolves once all of it is there. */
  send(placements) {
    this.sending = this.sending.catch(() => {}).then(() => this.sendAll(placements)); // one after the other
    return this.sending;
  }

  async sendAll(placements) {
    this.clock += 1;
    const needed = new Set(placements.flatMap((number) => this.placements[number].shapes));
    for (const number of needed) {
      const held = this.shapes.get(number);
      if (held) held.used = this.clock;
      else await this.sendShape(number);
      const { kind, wireframe } = this.description.shapes[number];
      const shape = this.shapes.get(number);
      if (kind === "triangles" && (wireframe || this.looks.wireframe) && !shape.edges) await this.sendEdges(number, shape);
    }
    this.free();
  }

  async sendShape(number) {
    const { kind, positions, normals, colors, indices } = this.description.shapes[number];
    const read = (array) => (array === undefined ? null : this.arrays.read(array));
    const [places, directions, paints, corners] = await Promise.all([positions, normals, colors, indices].map(read));
    const shape = new Shape(this.gl);
    if (kind === "lines") {
      shape.attribute(0, segments(places, corners), 3, { stride: 24, also: 1, divisor: 1 });
      shape.attribute(2, paints, 3, { divisor: 1 });
      shape.count = corners.length / 2;
    } else {
      shape.attribute(0, places, 3);
      shape.attribute(1, directions, 3);
      shape.attribute(2, paints, 3);
      shape.elements(corners);
      shape.count = corners ? corners.length : places.length / 3;
    }
    shape.used = this.clock;
    this.shapes.set(number, shape);
    this.statistics.uploads += 1;
    this.statistics.bytes += shape.bytes;
  }

  async sendEdges(number, shape) {
    const corners = await this.arrays.read(this.description.shapes[number].indices);
    const before = shape.bytes;
    shape.sendEdges(edges(corners));
    this.statistics.bytes += shape.bytes - before;
  }

  /** Frees what neither this nor the last call needed, longest unused first, until the rest is within the budget. */
  free() {
    const unused = [...this.shapes].filter(([, shape]) => shape.used < this.clock - 1);
    for (const [number, shape] of unused.sort((a, b) => a[1].used - b[1].used)) {
      if (this.statistics.bytes <= MEMORY_BUDGET) return;
      shape.free();
      this.shapes.delete(number);
      this.statistics.bytes -= shape.bytes;
    }
  }

  resize(width, height, density) {
    this.density = density;
    this.canvas.width = Math.max(1, Math.round(width * density));
    this.canvas.height = Math.max(1, Math.round(height * density));
  }

  /** Draws a frame, of clouds one in `every` points; what is hidden or has not been sent yet is left out. */
  draw(camera, placements, every = 1) {
    const { gl, canvas } = this;
    if (gl.isContextLost()) return;
    this.every = every;
    if (!this.target || this.target.width !== canvas.width || this.target.height !== canvas.height) {
      this.target?.free();
      this.target = new Target(gl, canvas.width, canvas.height, this.samples);
    }
    this.statistics.draws += 1;
    const [near, far] = camera.depthRange();
    this.lens = camera.lens();
    this.depthOf = [(far + near) / (far - near), ((-2 * far * near) / (far - near)) / camera.unit];
    this.target.bind(this.description.background);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    for (const number of placements) {
      const { item, shapes, pose } = this.placements[number];
      if (!this.looks.hidden.has(item)) {
        for (const shape of shapes) this.drawShape(shape, camera, this.poses.subarray(12 * pose, 12 * pose + 12), near);
      }
    }
    gl.disable(gl.DEPTH_TEST);
    this.target.resolve();
    this.showRelief();
  }

  drawShape(number, camera, pose, near) {
    const { gl, looks } = this;
    const shape = this.shapes.get(number);
    const { kind, size, plain, normals, colors, wireframe, cull, unlit } = this.description.shapes[number];
    if (!shape || shape.count === 0) return;
    const program = this.programs[kind];
    const toCamera = modelToCamera(camera.rotation, camera.eye, pose, camera.unit);
    const every = kind === "points" ? thinned(shape.count, this.every) : 1;
    const factor = looks.pointFactor * Math.min(Math.sqrt(every), 2);
    const pixels = size * this.density * (kind === "points" ? factor : 1);
    const suits = kind === "triangles" ? !unlit : colors === undefined;
    const lit = [suits, true, false][looks.light];
    const relief = kind === "points" && looks.light !== 2 && !(lit && normals !== undefined);
    gl.useProgram(program.program);
    gl.uniformMatrix4x3fv(program.at("to_camera"), false, toCamera);
    gl.uniformMatrix3fv(program.at("normal_to_camera"), false, normalMatrix(toCamera));
    gl.uniformMatrix3fv(program.at("to_world"), true, camera.rotation);
    gl.uniform4fv(program.at("lens"), this.lens);
    gl.uniform2fv(program.at("depth_of"), this.depthOf);
    gl.uniform1f(program.at("size"), pixels);
    gl.uniform1f(program.at("near"), near / camera.unit);
    gl.uniform2f(program.at("window"), this.canvas.width, this.canvas.height);
    gl.uniform1i(program.at("lit"), lit ? 1 : 0);
    gl.uniform1f(program.at("relief"), relief ? 1 : 0);
    gl.uniform1i(program.at("paint_normals"), looks.normals ? 1 : 0);
    gl.uniform1i(program.at("flat_faces"), normals === undefined ? 1 : 0);
    gl.vertexAttrib3f(1, 0, 0, 0);
    gl.vertexAttrib3f(2, plain[0] / 255, plain[1] / 255, plain[2] / 255);
    gl.bindVertexArray(shape.vertices);
    if (kind === "points") {
      shape.thin(every);
      gl.drawArrays(gl.POINTS, 0, Math.ceil(shape.count / every));
    } else if (kind === "lines") {
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, shape.count);
    } else {
      gl.enable(gl.POLYGON_OFFSET_FILL); // faces a little back, so that their edges are seen
      gl.polygonOffset(1, 1);
      if (cull) gl.enable(gl.CULL_FACE); // corners run counterclockwise where a face is seen from its front
      gl.drawElements(gl.TRIANGLES, shape.count, gl.UNSIGNED_INT, 0);
      gl.disable(gl.CULL_FACE);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      if (shape.edges && (wireframe || looks.wireframe)) this.drawEdges(program, shape, plain);
    }
    gl.bindVertexArray(null);
  }

  drawEdges(program, shape, plain) {
    const { gl } = this;
    gl.uniform1i(program.at("lit"), 0);
    gl.uniform1i(program.at("paint_normals"), 0);
    gl.bindVertexArray(shape.edges);
    gl.vertexAttrib3f(2, ...plain.map((value) => (EDGE_SHADE * value) / 255));
    gl.drawElements(gl.LINES, shape.edgeCount, gl.UNSIGNED_INT, 0);
  }

  showRelief() {
    const { gl } = this;
    const { relief } = this.programs;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.useProgram(relief.program);
    this.target.read(relief);
    gl.uniform2fv(relief.at("depth_of"), this.depthOf);
    gl.uniform1i(relief.at("reach"), Math.max(1, Math.round(1.5 * this.density)));
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Resolves when the card has drawn what it was told to. */
  async finished() {
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    gl.deleteSync(fence);
  }

  /** The depth [m] of what was drawn last at or beside a place of the canvas [CSS px], or null. */
  depthAt(x, y, camera) {
    const { gl } = this;
    const { probe } = this.programs;
    const corner = [x, this.canvas.height / this.density - y].map((v) => Math.round(v * this.density) - (PROBE >> 1));
    const bytes = new Uint8Array(4 * PROBE * PROBE);
    const texture = gl.createTexture();
    const frame = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, PROBE, PROBE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(0, 0, PROBE, PROBE);
    gl.useProgram(probe.program);
    this.target.read(probe);
    gl.uniform2i(probe.at("corner"), ...corner);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, PROBE, PROBE, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.deleteFramebuffer(frame);
    gl.deleteTexture(texture);
    const depth = nearestToMiddle(bytes);
    return depth === null ? null : (this.depthOf[1] / (2 * depth - 1 - this.depthOf[0])) * camera.unit;
  }
}

/** Of the depths in a square the one nearest to its middle at which there is anything. */
function nearestToMiddle(bytes) {
  let best = null;
  let least = Infinity;
  for (let i = 0; i < PROBE * PROBE; i++) {
    const depth = (bytes[4 * i] * 65536 + bytes[4 * i + 1] * 256 + bytes[4 * i + 2]) / 16777215;
    const distance = Math.hypot((i % PROBE) - (PROBE >> 1), Math.floor(i / PROBE) - (PROBE >> 1));
    if (depth < 0.9999999 && distance < least) [best, least] = [depth, distance];
  }
  return best;
}

/** Of how many points one is drawn, where one in `every` is to be; small clouds are spared. */
function thinned(count, every) {
  while (every > 1 && count / every < FEW) every /= 2;
  return every;
}

/** Whether the processor draws: then smoothed edges cost more than they give. */
function isSoftware(gl) {
  let name = gl.getParameter(gl.RENDERER);
  const info = name.startsWith("WebKit") ? gl.getExtension("WEBGL_debug_renderer_info") : null;
  if (info) name = gl.getParameter(info.UNMASKED_RENDERER_WEBGL);
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Both ends of each segment. */
function segments(positions, indices) {
  const ends = new Float32Array(3 * indices.length);
  for (let i = 0; i < indices.length; i++) {
    for (let k = 0; k < 3; k++) ends[3 * i + k] = positions[3 * indices[i] + k];
  }
  return ends;
}

/** The sides of triangles. */
function edges(indices) {
  const sides = new Uint32Array(2 * indices.length);
  for (let i = 0; i < indices.length; i++) {
    sides[2 * i] = indices[i];
    sides[2 * i + 1] = indices[i % 3 === 2 ? i - 2 : i + 1];
  }
  return sides;
}
