/** Joins the parts: the page's elements, keys, messages, and when to draw. */
const NO_WEBGL =
  "This page draws with WebGL 2, which this browser does not offer here. Open it in a current Chromium, Firefox or " +
  "Safari, and switch hardware acceleration on where it is off.";

const TOO_OLD =
  "This browser cannot unpack what this page carries. Open it in a Chromium, Firefox or Safari of 2023 or later.";

const at = (id) => document.getElementById(id);

class Player {
  constructor() {
    this.description = JSON.parse(at("description").textContent);
    const { title, background, items, series, frames, bounds, camera, arrays, block } = this.description;
    document.documentElement.style.setProperty("--background", `rgb(${background.map((v) => Math.round(255 * v)).join(" ")})`);
    at("title").textContent = title;
    at("title").hidden = title === "";
    this.camera = new Camera(camera, bounds);
    this.scene = new Scene(at("scene"), this.description, new Arrays(arrays, block));
    const draw = (every) => this.scene.draw(this.camera, this.shownPlacements(), every);
    this.pace = new Pace(draw, () => this.scene.finished());
    this.items = items.map((name, number) => this.makeItem(name, number));
    this.timeline = new Timeline(this.description, {
      prepare: (placements) => this.scene.send(placements),
      shown: (frame) => this.onShown(frame),
      drawn: () => !this.pace.waiting,
      failed: (error) => say(error.message),
    });
    this.plots = new Plots(at("plots"), series, frames.length, (frame) => this.goTo(frame));
    const changed = () => this.redraw();
    new Controls(at("scene"), this.camera, { changed, pick: (x, y) => this.pick(x, y) });
    this.listen();
  }

  async start() {
    const { frames, series } = this.description;
    at("bar").hidden = frames.length < 2;
    at("plots").hidden = series.length === 0;
    for (const element of document.querySelectorAll(".moving")) element.hidden = frames.length < 2;
    at("slider").max = Math.max(frames.length - 1, 0);
    new ResizeObserver(() => this.resize()).observe(at("stage"));
    this.resize();
    if (frames.length === 0) {
      at("panel").hidden = this.description.title === "";
      say("Nothing was recorded: there are no frames.");
      return;
    }
    await this.scene.readPoses();
    await this.timeline.go(0);
  }

  makeItem(name, number) {
    const row = document.createElement("li");
    const label = document.createElement("label");
    const box = document.createElement("input");
    const swatch = document.createElement("i");
    box.type = "checkbox";
    box.checked = true;
    box.addEventListener("change", () => {
      this.scene.looks.hidden[box.checked ? "delete" : "add"](number);
      this.redraw();
      this.tellCount();
    });
    const placed = this.scene.placements.find(({ item, shapes }) => item === number && shapes.length > 0);
    const first = placed && this.description.shapes[placed.shapes[0]];
    if (first && first.colors === undefined) swatch.style.background = `rgb(${first.plain.join(" ")})`;
    else swatch.hidden = true;
    label.append(box, swatch, name);
    row.append(label);
    at("items").append(row);
    return row;
  }

  listen() {
    const { timeline } = this;
    at("play").addEventListener("click", () => timeline.toggle());
    at("back").addEventListener("click", () => timeline.step(-1));
    at("forth").addEventListener("click", () => timeline.step(1));
    at("slider").addEventListener("input", () => this.goTo(Number(at("slider").value)));
    at("speed").addEventListener("change", () => (timeline.speed = Number(at("speed").value)));
    at("loop").addEventListener("change", () => (timeline.loop = at("loop").checked));
    at("help-button").addEventListener("click", () => this.toggleHelp());
    document.addEventListener("keydown", (event) => this.onKey(event));
    at("scene").addEventListener("webglcontextlost", (event) => event.preventDefault());
    at("scene").addEventListener("webglcontextrestored", () => this.restore());
  }

  goTo(frame) {
    this.timeline.pause();
    return this.timeline.go(frame);
  }

  toggleHelp() {
    at("help").hidden = !at("help").hidden;
    at("help-button").setAttribute("aria-expanded", String(!at("help").hidden));
  }

  /** Keys that an element of the page has a use for stay its own. */
  onKey(event) {
    const kind = event.target.type ?? event.target.tagName;
    if (event.ctrlKey || event.metaKey || event.altKey || /text|search|select/i.test(kind)) return;
    if (event.key === " " && /button|submit|checkbox/i.test(kind)) return;
    if (/^(Arrow|Home|End)/.test(event.key) && kind === "range") return;
    const action = this.action(event.shiftKey && event.key.startsWith("Arrow") ? `Shift ${event.key}` : event.key);
    if (!action) return;
    event.preventDefault();
    action();
    this.redraw();
  }

  action(key) {
    const { camera, scene, timeline } = this;
    const { looks } = scene;
    return {
      " ": () => timeline.toggle(),
      ArrowLeft: () => timeline.step(-1),
      ArrowRight: () => timeline.step(1),
      Home: () => this.goTo(0),
      End: () => this.goTo(timeline.last),
      "Shift ArrowLeft": () => camera.orbit(-0.1, 0),
      "Shift ArrowRight": () => camera.orbit(0.1, 0),
      "Shift ArrowUp": () => camera.orbit(0, -0.1),
      "Shift ArrowDown": () => camera.orbit(0, 0.1),
      "+": () => (looks.pointFactor = Math.min(looks.pointFactor * 1.25, 32)),
      "=": () => (looks.pointFactor = Math.min(looks.pointFactor * 1.25, 32)),
      "-": () => (looks.pointFactor = Math.max(looks.pointFactor / 1.25, 1 / 32)),
      r: () => camera.reset(),
      w: () => this.toggleWireframe(),
      n: () => (looks.normals = !looks.normals),
      l: () => (looks.light = (looks.light + 1) % 3),
      h: () => this.toggleHelp(),
      "?": () => this.toggleHelp(),
    }[key.length === 1 ? key.toLowerCase() : key];
  }

  async toggleWireframe() {
    this.scene.looks.wireframe = !this.scene.looks.wireframe;
    await this.scene.send(this.shownPlacements());
    this.redraw();
  }

  shownPlacements() {
    return this.description.frames[this.timeline.frame]?.shown ?? [];
  }

  onShown(frame) {
    const { frames } = this.description;
    const { label } = frames[frame];
    const inFrame = new Set(this.shownPlacements().map((number) => this.scene.placements[number].item));
    this.items.forEach((row, number) => row.classList.toggle("away", !inFrame.has(number)));
    at("slider").value = frame;
    at("slider").setAttribute("aria-valuetext", `${frame + 1} of ${frames.length} ${label}`);
    at("place").textContent = `${frame + 1} / ${frames.length}`;
    at("label").textContent = label;
    at("label").hidden = label === "";
    at("play").classList.toggle("playing", this.timeline.playing);
    at("play").setAttribute("aria-label", this.timeline.playing ? "Pause" : "Play");
    at("message").hidden = true;
    this.tellCount();
    this.plots.show(frame);
    document.documentElement.dataset.frame = frame;
    this.redraw();
  }

  /** How many points are shown; of how many, where some were left out, the frame's label says. */
  tellCount() {
    let count = 0;
    for (const { item, shapes } of this.shownPlacements().map((number) => this.scene.placements[number])) {
      for (const shape of this.scene.looks.hidden.has(item) ? [] : shapes.map((number) => this.description.shapes[number])) {
        if (shape.kind === "points") count += this.description.arrays[shape.positions].rows;
      }
    }
    at("count").hidden = count === 0;
    at("count").textContent = `${count.toLocaleString("en")} point${count === 1 ? "" : "s"} drawn`;
  }

  pick(x, y) {
    const depth = this.scene.depthAt(x, y, this.camera);
    return depth === null ? null : this.camera.unproject(x, y, depth);
  }

  resize() {
    const { width, height } = at("stage").getBoundingClientRect();
    this.camera.resize(width, height);
    this.scene.resize(width, height, Math.min(window.devicePixelRatio || 1, 2));
    this.pace.now();
    if (this.timeline.frame >= 0) this.plots.show(this.timeline.frame);
  }

  redraw() {
    this.pace.ask();
  }

  async restore() {
    this.scene.start();
    await this.scene.send(this.shownPlacements());
    this.redraw();
  }
}

function say(text) {
  at("message").textContent = text;
  at("message").hidden = false;
}

try {
  if (!window.DecompressionStream) throw new Error(TOO_OLD);
  const player = new Player();
  player.start().catch((error) => say(error.message));
  // for whoever embeds the page, and for its tests
  window.recording = {
    project: (point) => player.camera.project(point),
    go: (frame) => player.goTo(frame),
    statistics: () => ({ ...player.scene.statistics, every: player.scene.every, frame: player.timeline.frame, playing: player.timeline.playing }),
  };
} catch (error) {
  say(error instanceof NoWebGL ? NO_WEBGL : error.message);
}
