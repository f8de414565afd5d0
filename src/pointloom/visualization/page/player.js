/** Connects the parts of the player: elements, keys, messages, drawing. */
const NO_WEBGL =
  "This page draws with WebGL 2, which this browser does not support. Open it in a current Chromium, Firefox or " +
  "Safari, and enable hardware acceleration.";

const TOO_OLD =
  "This browser cannot decompress the data of this page. Open it in a Chromium, Firefox or Safari of 2023 or later.";

const at = (id) => document.getElementById(id);

class Player {
  constructor() {
    this.description = JSON.parse(at("description").textContent);
    const { title, background, items, series, frames, bounds, camera, arrays, block, key } = this.description;
    document.documentElement.style.setProperty("--background", `rgb(${background.map((v) => Math.round(255 * v)).join(" ")})`);
    at("title").textContent = title;
    at("title").hidden = title === "";
    if (key) Object.assign(at("key"), { src: key.image, alt: key.text, width: key.width, hidden: false });
    this.engine = new Engine(at("scene"), at("overlay"), { margin: 1e-3, scaleBar: false, onLost: () => this.fill() });
    this.engine.setBackground(background);
    this.engine.setBounds(...bounds);
    this.engine.setCamera({ position: camera.eye, rotation: camera.rotation, lens: camera });
    this.engine.views.camera.aimAtMiddle();
    this.engine.setHome();
    this.scene = new Recorded(this.engine, this.description, new Arrays(arrays, block));
    this.items = items.map((name, number) => this.makeItem(name, number));
    this.timeline = new Timeline(this.description, {
      prepare: (placements) => this.scene.send(placements),
      shown: (frame) => this.onShown(frame),
      drawn: () => !this.engine.pace.waiting,
      failed: (error) => showMessage(error.message),
    });
    this.plots = new Plots(at("plots"), series, frames.length, (frame) => this.goTo(frame));
    this.listen();
  }

  async start() {
    const { frames, series } = this.description;
    at("bar").hidden = frames.length < 2;
    at("plots").hidden = series.length === 0;
    for (const element of document.querySelectorAll(".moving")) element.hidden = frames.length < 2;
    at("slider").max = Math.max(frames.length - 1, 0);
    new ResizeObserver(() => this.timeline.frame >= 0 && this.plots.show(this.timeline.frame)).observe(at("stage"));
    if (frames.length === 0) {
      at("panel").hidden = this.description.title === "";
      showMessage("Nothing was recorded: there are no frames.");
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
      this.scene.hide(number, !box.checked);
      this.tellCount();
    });
    const placement = this.scene.placements.find(({ item, shapes }) => item === number && shapes.length > 0);
    const first = placement && this.description.shapes[placement.shapes[0]];
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
  }

  goTo(frame) {
    this.timeline.pause();
    return this.timeline.go(frame);
  }

  toggleHelp() {
    at("help").hidden = !at("help").hidden;
    at("help-button").setAttribute("aria-expanded", String(!at("help").hidden));
  }

  /** Keys that a focused element uses are left to it. */
  onKey(event) {
    const kind = event.target.type ?? event.target.tagName;
    if (event.ctrlKey || event.metaKey || event.altKey || /text|search|select/i.test(kind)) return;
    if (event.key === " " && /button|submit|checkbox/i.test(kind)) return;
    if (/^(Arrow|Home|End)/.test(event.key) && kind === "range") return;
    const name = { "=": "+" }[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
    const action = (event.shiftKey ? this.action(`Shift+${name}`) : null) ?? this.action(name);
    if (!action) return;
    event.preventDefault();
    action();
  }

  action(key) {
    const { timeline } = this;
    const runs = {
      " ": () => timeline.toggle(),
      ArrowLeft: () => timeline.step(-1),
      ArrowRight: () => timeline.step(1),
      Home: () => this.goTo(0),
      End: () => this.goTo(timeline.last),
      H: () => this.toggleHelp(),
      "?": () => this.toggleHelp(),
    };
    return runs[key] ?? this.engine.commands().find((command) => command.key === key)?.run;
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
    this.scene.show(this.shownPlacements());
  }

  /** Number of displayed points; the frame's label has the total if some were omitted. */
  tellCount() {
    let count = 0;
    for (const { item, shapes } of this.shownPlacements().map((number) => this.scene.placements[number])) {
      for (const shape of this.scene.hidden.has(item) ? [] : shapes.map((number) => this.description.shapes[number])) {
        if (shape.kind === "points") count += this.description.arrays[shape.positions].rows;
      }
    }
    at("count").hidden = count === 0;
    at("count").textContent = `${count.toLocaleString("en")} point${count === 1 ? "" : "s"} drawn`;
  }

  /** The context was lost. */
  async fill() {
    await this.scene.send(this.shownPlacements());
    this.scene.show(this.shownPlacements());
  }
}

function showMessage(text) {
  at("message").textContent = text;
  at("message").hidden = false;
}

try {
  if (!window.DecompressionStream) throw new Error(TOO_OLD);
  const player = new Player();
  const started = player.start().catch((error) => showMessage(error.message));
  // for embedding pages and tests
  window.pointloom = { ready: () => started.then(() => player.timeline.going).then(() => player.engine.ready()) };
  window.recording = {
    project: (point) => player.engine.project(point),
    go: (frame) => player.goTo(frame),
    statistics: () => ({ ...player.engine.statistics(), frame: player.timeline.frame, playing: player.timeline.playing }),
  };
} catch (error) {
  showMessage(error instanceof NoWebGL ? NO_WEBGL : error.message);
}
