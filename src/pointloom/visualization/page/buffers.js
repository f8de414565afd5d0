/** GPU resources: programs, buffers of nodes, and the render target. */
const SMALL = 2 ** 16; // bytes

class Program {
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, `#version 300 es\n${text}`);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(`a shader does not compile: ${gl.getShaderInfoLog(shader)}`);
      }
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`a program does not link: ${gl.getProgramInfoLog(this.program)}`);
    }
    this.locations = new Map();
    this.values = new Map();
  }

  /** Location of a uniform, or null (ignored). */
  at(name) {
    if (!this.locations.has(name)) this.locations.set(name, this.gl.getUniformLocation(this.program, name));
    return this.locations.get(name);
  }

  /** Sets a float or integer uniform if changed: most are equal for most nodes. */
  number(name, value) {
    if (this.values.get(name) === value) return;
    this.values.set(name, value);
    this.gl.uniform1f(this.at(name), value);
  }

  integer(name, value) {
    if (this.values.get(name) === value) return;
    this.values.set(name, value);
    this.gl.uniform1i(this.at(name), value);
  }
}

/** Attribute and components per row of each array kind. */
const VERTICES = { positions: [0, 3], normals: [1, 3], colors: [2, 3], uvs: [3, 2] };
const SEGMENTS = { positions: [0, 6], colors: [2, 3] };
const LAYOUTS = { points: VERTICES, triangles: VERTICES, lines: SEGMENTS };

/** GPU arrays of a node, shared by nodes with equal content. */
class Geometry {
  /** `keep`: keep arrays to restore a lost context. `changed`: called when a texture is ready. */
  constructor(gl, kind, keep, changed) {
    Object.assign(this, { gl, kind, keep, changed, users: 1, arrays: {}, texture: null });
    this.start(gl);
  }

  letGo() {
    [this.keep, this.arrays] = [false, {}];
  }

  start(gl) {
    Object.assign(this, { gl, buffers: {}, edges: null, every: 1, count: 0, uploads: 0 });
    this.vertices = gl.createVertexArray();
  }

  get bytes() {
    const bufferBytes = Object.values(this.buffers).reduce((sum, { bytes }) => sum + bytes, 0);
    return bufferBytes + (this.edges?.bytes ?? 0) + (this.texture?.bytes ?? 0);
  }

  get kept() {
    return Object.values(this.arrays).reduce((sum, { byteLength }) => sum + byteLength, 0);
  }

  /** Uploads arrays, replacing those of the same names. */
  send(arrays) {
    const { gl } = this;
    gl.bindVertexArray(this.vertices);
    for (const [name, values] of Object.entries(arrays)) {
      if (!values) continue;
      if (this.keep) this.arrays[name] = alone(values);
      this.uploads += 1;
      if (name === "texture") {
        this.texture?.free();
        this.texture = new Texture(gl, values, this.changed);
      } else {
        this.fill(name, values);
      }
    }
    this.layout();
    if (arrays.indices || arrays.positions) this.dropEdges();
  }

  remove(name) {
    delete this.arrays[name];
    if (!this.buffers[name]) return;
    this.gl.deleteBuffer(this.buffers[name].buffer);
    delete this.buffers[name];
    this.layout();
  }

  fill(name, values) {
    const { gl } = this;
    const target = name === "indices" ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
    let entry = this.buffers[name];
    if (!entry) entry = this.buffers[name] = { buffer: gl.createBuffer(), bytes: -1 };
    gl.bindBuffer(target, entry.buffer);
    if (entry.bytes === values.byteLength) gl.bufferSubData(target, 0, values);
    else gl.bufferData(target, values, entry.bytes < 0 ? gl.STATIC_DRAW : gl.DYNAMIC_DRAW);
    Object.assign(entry, { bytes: values.byteLength, numbers: values.length, ...kindOf(gl, values) });
  }

  point(location, width, { buffer, type, bytesEach }, { stride = 0, offset = 0, divisor = 0 } = {}) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, width, type, bytesEach < 4 && type !== gl.HALF_FLOAT, stride, offset);
    gl.vertexAttribDivisor(location, divisor);
  }

  rows(name, width) {
    return this.buffers[name] ? Math.floor(this.buffers[name].numbers / width) : 0;
  }

  /** Binds attributes; arrays that are too short are skipped. */
  layout() {
    const { gl, kind, buffers, every } = this;
    const count = this.rows("positions", kind === "lines" ? 6 : 3);
    this.has = {};
    gl.bindVertexArray(this.vertices);
    for (const [name, [location, numbers]] of Object.entries(LAYOUTS[kind])) {
      if (this.rows(name, numbers) < count || count === 0) continue;
      this.has[name] = true;
      const step = numbers * buffers[name].bytesEach;
      if (kind === "lines") {
        this.pointEnds(location, buffers[name], this.rows(name, 6) >= count ? 6 : 3);
      } else {
        this.point(location, numbers, buffers[name], { stride: step * every });
      }
    }
    for (const name of ["normals", "colors", "uvs"]) {
      const locations = kind === "lines" ? [2, 3] : [VERTICES[name][0]];
      if (LAYOUTS[kind][name] && !this.has[name]) for (const location of locations) gl.disableVertexAttribArray(location);
    }
    gl.bindVertexArray(null);
    this.elements = kind === "triangles" && buffers.indices ? buffers.indices.numbers : 0;
    this.count = kind === "triangles" && !buffers.indices ? count - (count % 3) : this.elements || count;
  }

  /** Both ends of a segment, or values per segment. */
  pointEnds(location, entry, numbers) {
    const stride = numbers * entry.bytesEach;
    for (const end of [0, 1]) this.point(location + end, 3, entry, { stride, offset: numbers === 6 ? (end * stride) / 2 : 0, divisor: 1 });
  }

  /** One in `every` points, at most 16, by the stride, which must be below 256 bytes. */
  thin(every) {
    if (every === this.every) return;
    this.every = every;
    this.layout();
  }

  /** Edges of the triangles, from the GPU's indices, so that no copy is needed. */
  makeEdges() {
    const { gl } = this;
    const { positions, indices } = this.buffers;
    if (this.edges || !positions || this.count === 0) return;
    let corners = null;
    if (indices) {
      corners = new Uint32Array(indices.numbers);
      gl.bindVertexArray(this.vertices);
      gl.getBufferSubData(gl.ELEMENT_ARRAY_BUFFER, 0, corners);
    }
    const sides = sidesOf(corners, this.count);
    const buffer = gl.createBuffer();
    this.edges = { vertices: gl.createVertexArray(), buffer, count: sides.length, bytes: sides.byteLength };
    gl.bindVertexArray(this.edges.vertices);
    this.point(0, 3, positions);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, sides, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }

  dropEdges() {
    if (!this.edges) return;
    this.gl.deleteBuffer(this.edges.buffer);
    this.gl.deleteVertexArray(this.edges.vertices);
    this.edges = null;
  }

  /** The context was lost. */
  forget() {
    Object.assign(this, { buffers: {}, edges: null, vertices: null, texture: null, count: 0 });
  }

  free() {
    const { gl } = this;
    this.dropEdges();
    this.texture?.free();
    for (const { buffer } of Object.values(this.buffers)) gl.deleteBuffer(buffer);
    gl.deleteVertexArray(this.vertices);
    this.buffers = {};
    this.count = 0;
  }
}

/** Copies a small array, so that keeping it does not keep its large message. */
function alone(values) {
  return values.byteLength < SMALL && values.buffer.byteLength > 4 * values.byteLength ? values.slice() : values;
}

/** Type of an array: unsigned 16-bit words are half floats, integers are normalized. */
function kindOf(gl, values) {
  const types = { Float32Array: gl.FLOAT, Float16Array: gl.HALF_FLOAT, Uint16Array: gl.HALF_FLOAT, Int16Array: gl.SHORT };
  return { type: types[values.constructor.name] ?? gl.UNSIGNED_BYTE, bytesEach: values.BYTES_PER_ELEMENT };
}

/** Edges of triangles; `corners` null: three consecutive vertices each. */
function sidesOf(corners, count) {
  const sides = new Uint32Array(2 * count);
  for (let i = 0; i < count; i++) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    sides[2 * i] = corners ? corners[i] : i;
    sides[2 * i + 1] = corners ? corners[next] : next;
  }
  return sides;
}

/** Color and depth textures of a render target; multisampled ones are resolved into them. */
class Target {
  constructor(gl, width, height, samples) {
    Object.assign(this, { gl, width, height });
    this.colors = this.texture(gl.RGBA8);
    this.depths = this.texture(gl.DEPTH_COMPONENT24);
    this.frame = this.framebuffer((attachment, texture) =>
      gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0), this.colors, this.depths);
    if (samples === 0) return;
    this.renders = [gl.RGBA8, gl.DEPTH_COMPONENT24].map((kind) => {
      const render = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, render);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, kind, width, height);
      return render;
    });
    this.sampled = this.framebuffer((attachment, render) =>
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, render), ...this.renders);
  }

  texture(kind) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, kind, this.width, this.height);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return texture;
  }

  framebuffer(attach, colors, depths) {
    const { gl } = this;
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    attach(gl.COLOR_ATTACHMENT0, colors);
    attach(gl.DEPTH_ATTACHMENT, depths);
    return frame;
  }

  bind(background) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sampled ?? this.frame);
    gl.clearColor(...background, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Resolves color samples; for depth the GPU takes one sample. */
  resolve() {
    const { gl, width, height } = this;
    if (!this.sampled) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.sampled);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.frame);
    const parts = gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT;
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, parts, gl.NEAREST);
  }

  read(program) {
    const { gl } = this;
    for (const [unit, name] of ["colors", "depths"].entries()) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this[name]);
      gl.uniform1i(program.at(name), unit);
    }
  }

  free() {
    const { gl } = this;
    for (const texture of [this.colors, this.depths]) gl.deleteTexture(texture);
    for (const render of this.renders ?? []) gl.deleteRenderbuffer(render);
    for (const frame of [this.frame, this.sampled]) if (frame) gl.deleteFramebuffer(frame);
  }
}
