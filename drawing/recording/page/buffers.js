/** What lives on the graphics card: programs, the buffers of shapes, and the picture that is drawn into. */
class Program {
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
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
    this.places = new Map();
  }

  /** The place of a uniform; null, which is ignored, where the program has none of this name. */
  at(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }
}

class Shape {
  constructor(gl) {
    this.gl = gl;
    this.vertices = gl.createVertexArray();
    this.buffers = [];
    this.bytes = 0;
    this.count = 0;
    this.edges = null;
    this.every = 1;
    this.attributes = [];
  }

  fill(target, values) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, values, gl.STATIC_DRAW);
    this.buffers.push(buffer);
    this.bytes += values.byteLength;
    return buffer;
  }

  /** `also`: a second attribute that follows in each row, as the other end of a segment does. */
  attribute(place, values, width, { stride = 0, also = null, divisor = 0 } = {}) {
    if (!values) return;
    const { gl } = this;
    const kind = { Float32Array: gl.FLOAT, Int16Array: gl.SHORT, Uint8Array: gl.UNSIGNED_BYTE }[values.constructor.name];
    gl.bindVertexArray(this.vertices);
    const buffer = this.fill(gl.ARRAY_BUFFER, values);
    if (place === 0) this.positions = buffer;
    this.attributes.push({ place, buffer, width, kind, bytes: width * values.BYTES_PER_ELEMENT });
    for (const [at, offset] of also === null ? [[place, 0]] : [[place, 0], [also, stride / 2]]) {
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, width, kind, kind !== gl.FLOAT, stride, offset);
      gl.vertexAttribDivisor(at, divisor);
    }
    gl.bindVertexArray(null);
  }

  /** Of points one in `every`, at most 16: the rows between are stepped over, and a step has less than 256 bytes. */
  thin(every) {
    if (every === this.every) return;
    const { gl } = this;
    this.every = every;
    for (const { place, buffer, width, kind, bytes } of this.attributes) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.vertexAttribPointer(place, width, kind, kind !== gl.FLOAT, bytes * every, 0);
    }
  }

  elements(indices) {
    if (!indices) return;
    this.gl.bindVertexArray(this.vertices);
    this.fill(this.gl.ELEMENT_ARRAY_BUFFER, indices);
    this.gl.bindVertexArray(null);
  }

  sendEdges(sides) {
    const { gl } = this;
    this.edges = gl.createVertexArray();
    this.edgeCount = sides.length;
    gl.bindVertexArray(this.edges);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.positions);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    this.fill(gl.ELEMENT_ARRAY_BUFFER, sides);
    gl.bindVertexArray(null);
  }

  free() {
    const { gl } = this;
    for (const buffer of this.buffers) gl.deleteBuffer(buffer);
    gl.deleteVertexArray(this.vertices);
    if (this.edges) gl.deleteVertexArray(this.edges);
  }
}

/** Colours and depths of a picture as textures; with samples they are drawn beside and averaged into these. */
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
    gl.viewport(0, 0, this.width, this.height);
    gl.clearColor(...background, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Averages the samples of colours; of depths the card takes one. */
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
