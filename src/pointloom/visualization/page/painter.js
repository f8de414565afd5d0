/** Draws nodes: all views into an offscreen image, then with eye-dome lighting onto the canvas. */
const FEW = 15_000; // points: thinning fewer saves no time
const EDGE_SHADE = 0.12; // of the color of a surface, as in rendered images
const PROBE = 9; // [px] side of the square that is searched for a depth
const GRAY = [204, 199, 189]; // of surfaces without a color: light and warm, darker than a white background
const BLUE = [89, 128, 158]; // of points and lines without a color
const LARGEST_POINT = 256; // [px]

const PROGRAMS = {
  points: [SOLID_VERTEX, POINT_FRAGMENT],
  triangles: [SOLID_VERTEX, FACE_FRAGMENT],
  lines: [LINE_VERTEX, LINE_FRAGMENT],
  relief: [WHOLE_VERTEX, RELIEF_FRAGMENT],
  probe: [WHOLE_VERTEX, PROBE_FRAGMENT],
};

class NoWebGL extends Error {}

class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: false, powerPreference: "high-performance" });
    if (!this.gl) throw new NoWebGL("this browser has no WebGL 2 here");
    this.density = 1;
    this.start();
  }

  /** Sets up a new or restored context. */
  start() {
    const { gl } = this;
    this.programs = {};
    this.target = null;
    this.samples = isSoftware(gl) ? 0 : Math.min(4, gl.getParameter(gl.MAX_SAMPLES));
    this.empty = gl.createVertexArray();
    this.largest = Math.min(LARGEST_POINT, gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE)[1]);
  }

  program(name) {
    this.programs[name] ??= new Program(this.gl, ...PROGRAMS[name]);
    return this.programs[name];
  }

  resize(width, height, density) {
    this.density = density;
    this.canvas.width = Math.max(1, Math.round(width * density));
    this.canvas.height = Math.max(1, Math.round(height * density));
  }

  /** Draws the nodes in each view, one in `every` points of clouds. */
  draw(views, nodes, looks, background, every = 1) {
    const { gl, canvas } = this;
    Object.assign(this, { looks, every, calls: 0, points: 0, triangles: 0 });
    if (!this.target || this.target.width !== canvas.width || this.target.height !== canvas.height) {
      this.target?.free();
      this.target = new Target(gl, canvas.width, canvas.height, this.samples);
    }
    this.target.bind(background);
    gl.depthFunc(gl.LEQUAL);
    this.frames = views.cameras.map((camera) => this.frameOf(camera));
    for (const frame of this.frames) this.drawView(frame, nodes);
    this.target.resolve();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.clearColor(...background.map((value) => 0.75 * value + 0.125), 1); // separates the views
    gl.clear(gl.COLOR_BUFFER_BIT);
    for (const frame of this.frames) this.showRelief(frame);
    gl.viewport(0, 0, canvas.width, canvas.height);
  }

  /** Uniforms of a view's camera, and its canvas rectangle: left, bottom, width, height. */
  frameOf(camera) {
    const { density, canvas } = this;
    const { x, y, width, height } = camera.box;
    const [left, top] = [Math.round(x * density), Math.round(y * density)];
    const [right, bottom] = [Math.round((x + width) * density), Math.round((y + height) * density)];
    const box = [left, canvas.height - bottom, Math.max(1, right - left), Math.max(1, bottom - top)];
    const range = camera.depthRange();
    const { unit, orthographic: parallel } = camera;
    const pivot = camera.pivotDepth() / unit;
    const focal = (camera.pixels().fy * density) / (parallel ? pivot : 1); // [px] of an object as large as its depth
    return { camera, box, unit, parallel, pivot, focal, near: range[0] / unit, lens: camera.lens(), depthOf: camera.depthFactors(range) };
  }

  drawView(frame, nodes) {
    const { gl } = this;
    this.frame = frame;
    this.used = new Set();
    gl.viewport(...frame.box);
    gl.enable(gl.DEPTH_TEST);
    const over = [];
    for (const node of nodes) {
      if (!node.geometry || node.geometry.count === 0) continue;
      if ((node.props.opacity ?? 1) < 1) over.push(node);
      else this.drawNode(node);
    }
    if (over.length > 0) this.drawOver(over);
    gl.disable(gl.DEPTH_TEST);
  }

  /** Transparent nodes: farthest first, without writing depths, back faces before front faces. */
  drawOver(nodes) {
    const { gl } = this;
    const { camera } = this.frame;
    const forward = column(camera.rotation, 2);
    const depth = ({ world }) => dot(subtract([world[3], world[7], world[11]], camera.eye), forward);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.colorMask(true, true, true, false); // alpha controls eye-dome lighting
    gl.depthMask(false);
    for (const node of nodes.sort((a, b) => depth(b) - depth(a))) {
      if (node.kind !== "triangles" || node.props.cull) this.drawNode(node);
      else for (const side of [gl.FRONT, gl.BACK]) this.drawNode(node, side);
    }
    gl.depthMask(true);
    gl.colorMask(true, true, true, true);
    gl.disable(gl.BLEND);
  }

  /** Program of a node with the shared uniforms of a view. */
  use(name) {
    const program = this.program(name);
    const { gl, frame } = this;
    gl.useProgram(program.program);
    if (this.used.has(program)) return program;
    this.used.add(program);
    const { camera } = frame;
    gl.uniformMatrix3fv(program.at("to_world"), true, camera.rotation);
    gl.uniform4fv(program.at("lens"), frame.lens);
    gl.uniform2fv(program.at("depth_of"), frame.depthOf);
    program.integer("parallel", frame.parallel ? 1 : 0);
    program.integer("from_afar", frame.parallel ? 1 : 0);
    program.number("near", frame.near);
    program.number("lift", 0.0005 * frame.pivot * frame.depthOf[0]);
    gl.uniform2f(program.at("window"), frame.box[2], frame.box[3]);
    gl.uniform2f(program.at("sizes"), 1, this.largest);
    program.integer("paint_normals", this.looks.normals ? 1 : 0);
    program.integer("image", 2); // not those that are rendered to
    return program;
  }

  drawNode(node, hiddenSide = null) {
    const { gl, frame, looks } = this;
    const { geometry, props, kind, world } = node;
    const program = this.use(kind);
    const toCamera = modelToCamera(frame.camera.rotation, frame.camera.eye, world, frame.unit);
    const every = kind === "points" ? thinned(geometry.count, this.every) : 1;
    const { normals, colors, positions } = geometry.has;
    if (!positions) return;
    gl.uniformMatrix4x3fv(program.at("to_camera"), false, toCamera);
    const isFace = kind === "triangles";
    if (isFace || normals) gl.uniformMatrix3fv(program.at("normal_to_camera"), false, normalMatrix(toCamera));
    const suits = isFace ? props.lit !== false : !colors;
    const lit = [suits, true, false][looks.light];
    program.integer("lit", lit ? 1 : 0);
    program.number("opacity", props.opacity ?? 1);
    if (kind === "points") this.setPoints(program, node, every, lit);
    else if (!isFace) program.number("size", (props.width ?? 1) * this.density);
    const plain = props.plain ?? (isFace ? GRAY : BLUE);
    if (!normals && kind === "points") gl.vertexAttrib3f(1, 0, 0, 0);
    if (!colors) {
      gl.vertexAttrib3f(2, plain[0] / 255, plain[1] / 255, plain[2] / 255);
      if (kind === "lines") gl.vertexAttrib3f(3, plain[0] / 255, plain[1] / 255, plain[2] / 255);
    }
    gl.bindVertexArray(geometry.vertices);
    this.calls += 1;
    if (kind === "points") {
      geometry.thin(every);
      gl.bindVertexArray(geometry.vertices);
      gl.drawArrays(gl.POINTS, 0, Math.ceil(geometry.count / every));
      this.points += Math.ceil(geometry.count / every);
    } else if (kind === "lines") {
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, geometry.count);
    } else {
      this.drawFaces(program, node, plain, hiddenSide);
    }
    gl.bindVertexArray(null);
  }

  setPoints(program, { props, geometry, world }, every, lit) {
    const { frame, looks } = this;
    const factor = looks.pointFactor * Math.min(Math.sqrt(every), 2);
    const size = props.size ?? 3;
    const pixels = props.metric ? (size * scaleOf(world) * frame.focal) / frame.unit : size * this.density;
    program.number("size", pixels * factor);
    program.integer("metric", props.metric ? 1 : 0);
    const relief = props.relief !== false && looks.light !== 2 && !(lit && geometry.has.normals);
    program.number("relief", relief ? 1 : 0);
  }

  drawFaces(program, { props, geometry }, plain, hiddenSide) {
    const { gl } = this;
    const { texture } = geometry;
    const textured = Boolean(texture?.texture && geometry.has.uvs);
    program.integer("flat_faces", geometry.has.normals ? 0 : 1);
    program.integer("textured", textured ? 1 : 0);
    program.integer("metric", 0);
    if (textured) {
      gl.activeTexture(gl.TEXTURE2);
      gl.bindTexture(gl.TEXTURE_2D, texture.texture);
    }
    // Faces are offset backward, so that points and edges on them are visible. Slope-dependent only if edges are drawn:
    // otherwise the face behind would show through at silhouettes.
    const edged = props.wireframe || this.looks.wireframe;
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(edged ? 1 : 0, edged ? 1 : 4);
    if (props.cull || hiddenSide) gl.enable(gl.CULL_FACE); // front faces are counterclockwise
    gl.cullFace(hiddenSide ?? gl.BACK);
    if (geometry.elements) gl.drawElements(gl.TRIANGLES, geometry.count, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, 0, geometry.count);
    this.triangles += geometry.count / 3;
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (edged) this.drawEdges(program, geometry, plain);
  }

  drawEdges(program, geometry, plain) {
    const { gl } = this;
    geometry.makeEdges();
    program.integer("lit", 0);
    program.integer("textured", 0);
    program.integer("paint_normals", 0);
    gl.bindVertexArray(geometry.edges.vertices);
    gl.vertexAttrib3f(2, ...plain.map((value) => (EDGE_SHADE * value) / 255));
    gl.drawElements(gl.LINES, geometry.edges.count, gl.UNSIGNED_INT, 0);
    program.integer("paint_normals", this.looks.normals ? 1 : 0);
    this.calls += 1;
  }

  /** First and last column and row of a view in the image. */
  corners([left, bottom, width, height]) {
    return [left, bottom, left + width - 1, bottom + height - 1];
  }

  showRelief({ box, depthOf, parallel, pivot }) {
    const { gl } = this;
    const relief = this.program("relief");
    gl.viewport(...box);
    gl.useProgram(relief.program);
    this.target.read(relief);
    gl.uniform2fv(relief.at("depth_of"), depthOf);
    gl.uniform4iv(relief.at("box"), this.corners(box));
    relief.integer("parallel", parallel ? 1 : 0);
    relief.number("pivot", pivot);
    relief.integer("radius", Math.max(1, Math.round(1.5 * this.density)));
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Resolves when the GPU has finished. */
  async finished() {
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    gl.deleteSync(fence);
  }

  /** Depth [m] last drawn at or near a canvas position [CSS px], or null. */
  depthAt(x, y, view) {
    const { gl } = this;
    const probe = this.program("probe");
    const frame = this.frames?.[view];
    if (!frame || !this.target || gl.isContextLost()) return null;
    const corner = [x, this.canvas.height / this.density - y].map((v) => Math.round(v * this.density) - (PROBE >> 1));
    const bytes = new Uint8Array(4 * PROBE * PROBE);
    const texture = gl.createTexture();
    const buffer = gl.createFramebuffer();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, PROBE, PROBE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(0, 0, PROBE, PROBE);
    gl.useProgram(probe.program);
    this.target.read(probe);
    gl.uniform2i(probe.at("corner"), ...corner);
    gl.uniform4iv(probe.at("box"), this.corners(frame.box));
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, PROBE, PROBE, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.deleteFramebuffer(buffer);
    gl.deleteTexture(texture);
    const depth = nearestToMiddle(bytes);
    if (depth === null) return null;
    const clipped = 2 * depth - 1;
    const [a, b] = frame.depthOf;
    return (frame.parallel ? (clipped - b) / a : b / (clipped - a)) * frame.unit;
  }
}

/** Nearest valid depth to the center of a square. */
function nearestToMiddle(bytes) {
  let best = null;
  let nearest = Infinity;
  for (let i = 0; i < PROBE * PROBE; i++) {
    const depth = (bytes[4 * i] * 65536 + bytes[4 * i + 1] * 256 + bytes[4 * i + 2]) / 16777215;
    const distance = Math.hypot((i % PROBE) - (PROBE >> 1), Math.floor(i / PROBE) - (PROBE >> 1));
    if (depth < 0.9999999 && distance < nearest) [best, nearest] = [depth, distance];
  }
  return best;
}

/** Thinning factor of a cloud for `every`; small clouds are drawn completely. */
function thinned(count, every) {
  while (every > 1 && count / every < FEW) every /= 2;
  return every;
}

/** True for software rendering: antialiasing is then too slow. */
function isSoftware(gl) {
  let name = gl.getParameter(gl.RENDERER);
  const info = name.startsWith("WebKit") ? gl.getExtension("WEBGL_debug_renderer_info") : null;
  if (info) name = gl.getParameter(info.UNMASKED_RENDERER_WEBGL);
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
