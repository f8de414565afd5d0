/** Connects the parts of a live page: messages of the program to scene, panel and texts, and user actions back. */
const VERSION = 1;
const ARRAYS_OF_NODES = ["positions", "colors", "normals", "indices", "uvs", "texture"];
const KEPT_VIEW = 3000; // [ms] after a reconnection in which the page keeps its camera
// Keys of the engine that programs use for tools, and their replacements.
const OTHER_KEYS = { M: "S", "Shift+M": "Shift+S" };
const OF_PROGRAMS = ["R", "N", "W", "+", "-"]; // programs apply these keys to all pages: not offered twice
const LONGEST_MOVE = 2000; // [ms] after which a signal is sent even if the image is not complete
const NO_WEBGL_HERE =
  "The scene is drawn with WebGL 2, which this browser does not support. Open the page in a current Chromium, Firefox " +
  "or Safari, and enable hardware acceleration.";

class Live {
  constructor() {
    this.pageTitle = document.title;
    this.keptUntil = 0;
    this.clicks = false;
    this.notices = new Notices({
      list: byId("notices"), progress: byId("progress"), state: byId("state"), hint: byId("hint"), tryNow: () => this.connection.hurry(),
    });
    this.connection = new Connection({
      received: (buffer) => this.receive(buffer), stateChanged: (state, more) => this.onState(state, more), hello: () => this.hello(),
    });
    const send = (message, maxLength) => this.connection.send(message, maxLength);
    this.panel = new Panel({
      root: byId("panel"), keys: byId("keys"), bar: byId("bar"), send,
      notify: (title, text) => this.notices.notify(title, text, 8, "error"),
      changed: () => this.onPanel(), isBusy: () => this.connection.isBusy,
    });
    this.commands = new Commands({ send, panel: this.panel });
    this.palette = new Palette(byId("palette"), this.commands);
    this.help = new Help(byId("help"), this.commands);
    this.startEngine();
    this.theme = new Theme((color) => this.engine?.setBackground(color, true));
    this.frame = new Frame({
      body: document.body, side: byId("side"), edge: byId("edge"), grip: byId("grip"), toggled: (shown) => this.onFrame(shown),
    });
    this.operations = this.makeOperations();
    this.addCommands();
    this.fillToolbar();
    this.theme.apply();
    this.onPanel();
  }

  start() {
    this.notices.setState("connecting");
    this.connection.open();
  }

  startEngine() {
    this.tellCamera = onceAPicture(() => this.sayCamera());
    try {
      this.engine = new Engine(byId("scene"), byId("overlay"), {
        onCamera: () => this.tellCamera(),
        onClick: (x, y) => this.onClick(x, y),
        onLost: (ids) => ids.length > 0 && this.connection.startAgain(),
      });
    } catch (error) {
      this.engine = null;
      this.notices.notify("The scene cannot be drawn", error instanceof NoWebGL ? NO_WEBGL_HERE : error.message, 3600, "error");
    }
  }

  /** Applies one message before the next frame; a failing operation does not affect the others. */
  receive(buffer) {
    let batch;
    try {
      batch = readBatch(buffer);
    } catch (error) {
      return console.error(`a message of the program could not be read: ${error.message}`);
    }
    const { operations, arrays } = batch;
    for (const operation of operations) {
      try {
        this.operations[operation.op]?.(operation, arrays);
      } catch (error) {
        console.error(`the operation ${operation.op} of the program failed: ${error.stack}`);
      }
    }
  }

  makeOperations() {
    const { engine, panel, commands, notices } = this;
    const parts = (operation, arrays) => splitArrays(operation, arrays);
    const offered = (change) => (op, arrays) => {
      change(op, arrays);
      this.palette.refresh();
    };
    return {
      node: (op, arrays) => engine?.add(op.id, op.parent, op.kind, ...parts(op, arrays)),
      set: (op, arrays) => engine?.set(op.id, ...parts(op, arrays)),
      drop: ({ id }) => engine?.drop(id),
      camera: (op) => this.putCamera(op),
      background: ({ color, own }) => this.theme.setGround(color, own === true),
      clicks: ({ on }) => this.setClicks(on),
      bounds: ({ low, high }) => engine?.setBounds(low, high),
      control: offered((op, arrays) => panel.add(op, arrays)),
      setcontrol: offered((op, arrays) => panel.set(op, arrays)),
      dropcontrol: offered(({ id }) => panel.drop(id)),
      rows: (op) => panel.rows(op),
      command: offered((op) => commands.add(op)),
      dropcommand: offered(({ id }) => commands.drop(id)),
      notify: ({ title, text, seconds, kind }) => notices.notify(title, text, seconds, kind),
      progress: ({ text, share }) => notices.setProgress(text ?? "", share ?? null),
      hint: ({ text }) => notices.setHint(text ?? ""),
      title: ({ text }) => this.setTitle(text),
      download: ({ name, mime, data }, arrays) => saveAs(new Blob([arrays[data].data], { type: mime }), name),
      sign: ({ n }) => this.onSign(n),
      sync: ({ n }) => this.connection.onSync(n),
      end: ({ text }) => this.connection.end(text ?? ""),
      unit: ({ text }) => engine?.setUnit(text ?? null),
      clear: () => this.clear(),
    };
  }

  clear() {
    this.engine?.clear();
    this.panel.clear();
    this.commands.clear();
    this.notices.setProgress("");
    this.notices.setHint("");
    this.setClicks(false);
  }

  /** After a reconnection the page keeps its camera: the program only knows the initial one. */
  putCamera({ op, ...fields }) {
    if (performance.now() < this.keptUntil) {
      for (const name of ["position", "rotation", "fov", "pivot", "up", "orthographic"]) delete fields[name];
    }
    this.engine?.setCamera(fields);
  }

  setTitle(text) {
    byId("title").textContent = text || this.pageTitle;
    document.title = text || this.pageTitle;
  }

  setClicks(on) {
    this.clicks = on === true;
    byId("picture").classList.toggle("clicks", this.clicks);
  }

  /** Answered when the image with all earlier messages is drawn. */
  async onSign(n) {
    const socket = this.connection.socket;
    if (this.engine) await Promise.race([this.engine.settled(), whileSeen(LONGEST_MOVE)]);
    if (socket === this.connection.socket) this.connection.send({ say: "sign", n });
  }

  /** Resolves when the program has handled all actions, and its answers are drawn. */
  async ready() {
    await this.engine?.ready();
    await nextFrame(); // the camera is sent once per frame
    this.panel.sayPending();
    await this.connection.sync();
    await this.engine?.ready();
  }

  hello() {
    return { say: "hello", size: this.size(), version: VERSION };
  }

  size() {
    const { width, height } = byId("picture").getBoundingClientRect();
    return [width, height].map((side) => clamp(Math.round(side), 1, 16384));
  }

  sayCamera() {
    if (this.engine) this.onLook();
    if (!this.engine || !this.connection.isOpen) return;
    if (this.connection.isBusy) return void setTimeout(this.tellCamera, 100);
    const { position, rotation, fov, pivot, size, orthographic } = this.engine.camera();
    this.connection.send({ say: "camera", position, rotation, fov, pivot, size, orthographic });
  }

  onClick(x, y) {
    if (!this.clicks) return;
    this.panel.sayPending();
    this.sayCamera(); // the program evaluates clicks with the current camera
    this.connection.send({ say: "click", x: clamp(x, 0, 1), y: clamp(y, 0, 1) });
  }

  onState(state, { text, again, before }) {
    if (state === "ended" && before === "ended" && !text) return; // the first value counts
    this.notices.setState(state, { text, hadScene: this.connection.wasOpen });
    if (state !== "open") return this.notices.setProgress("");
    if (again) this.keptUntil = performance.now() + KEPT_VIEW;
    if (again) setTimeout(this.tellCamera, 0);
  }

  onPanel() {
    document.body.classList.toggle("without-panel", byId("panel").children.length === 0);
  }

  onFrame(shown) {
    this.panelButton?.setAttribute("aria-pressed", shown);
  }

  async savePicture() {
    if (!this.engine) return;
    const picture = await composePicture(await this.engine.screenshot(), byId("keys"));
    const time = new Date().toISOString().slice(0, 19).replace("T", " ").replaceAll(":", ".");
    saveAs(picture, `${byId("title").textContent || "scene"} ${time}.png`.replace(/[\\/:*?"<>|]/g, "_"));
  }

  addCommands() {
    const { commands, panel } = this;
    const isTimed = () => panel.timeline !== undefined;
    const time = (label, keys, run) => commands.addOwn("Time", label, keys, () => run(panel.timeline), isTimed);
    time("Play or pause", ["space"], (line) => line.toggle());
    time("One step back", ["arrowleft"], (line) => line.step(-1));
    time("One step forward", ["arrowright"], (line) => line.step(1));
    time("To the beginning", ["home"], (line) => line.go(0));
    time("To the end", ["end"], (line) => line.go(line.steps.count));
    commands.addOwn("Page", "All commands", ["Ctrl+K"], () => this.palette.open());
    commands.addOwn("Page", "Keys and commands", ["H", "?"], () => this.help.open());
    commands.addOwn("Page", "Save the page's picture", ["Shift+P"], () => this.savePicture());
    commands.addOwn("Page", "Light or dark", ["D"], () => this.theme.toggle());
    commands.addOwn("Page", "Show or hide the panel", ["T"], () => this.frame.toggle());
    for (const { key, label, group, run } of this.engine?.commands() ?? []) {
      const isThere = () => !OF_PROGRAMS.includes(key) || !commands.isTaken(key);
      commands.addOwn(group || "View", label, [OTHER_KEYS[key] ?? key], run, isThere);
    }
  }

  /** Most frequent actions in one row; all are in the palette, too. */
  fillToolbar() {
    const { engine } = this;
    const bar = new Toolbar(byId("tools"));
    if (engine) {
      const camera = () => engine.camera();
      const pressed = (button, on) => button.setAttribute("aria-pressed", on);
      const up = (axis) => [`${axis.toUpperCase()} up`, () => engine.setUp(axis), () => Math.abs(camera().up["xyz".indexOf(axis)]) > 0.9];
      const along = ["+x", "-x", "+y", "-y", "+z", "-z"].map((axis) => [`Along ${axis.replace("-", "−")}`, () => engine.lookAlong(axis)]);
      const views = (count, label) => [label, () => engine.setViews(count, true), () => engine.views.cameras.length === count];
      const lights = ["Automatic light", "Light everywhere", "No light"].map((label, light) => [
        label, () => this.setLook("light", light), () => engine.looks.light === light,
      ]);
      bar.add("fit", "Fit the scene", () => engine.fit(), { key: "F", narrow: true });
      bar.addMenu("axes", "Look along an axis", [...along, null, up("z"), up("y")], { narrow: true });
      this.lensButton = bar.add("orthographic", "Orthographic projection", () => engine.setOrthographic(!camera().orthographic), { key: "O" });
      bar.addMenu("split", "Side-by-side views", [views(1, "One view"), views(2, "Two views"), views(4, "Four views")]);
      bar.addMenu("light", "Light", lights);
      this.meshButton = bar.add("mesh", "Edges of triangles, in this page", () => this.setLook("wireframe", !engine.looks.wireframe));
      pressed(this.lensButton, false);
      pressed(this.meshButton, false);
      bar.addGap();
      bar.add("camera", "Save the page's picture", () => this.savePicture(), { key: "Shift+P" });
    }
    bar.add("search", "All commands", () => this.palette.open(), { key: "Ctrl+K", narrow: true });
    bar.add("help", "Keys and commands", () => this.help.open(), { key: "H", narrow: true });
    bar.add("theme", "Light or dark", () => this.theme.toggle(), { key: "D", narrow: true });
    this.panelButton = bar.add("panel", "Show or hide the panel", () => this.frame.toggle(), { key: "T" });
    this.panelButton.classList.add("for-panel");
    this.onFrame(this.frame.isShown);
  }

  setLook(name, value) {
    this.engine.looks[name] = value;
    this.engine.redraw();
    this.onLook();
  }

  /** Icons show the state, whoever changed it. */
  onLook() {
    this.meshButton?.setAttribute("aria-pressed", this.engine.looks.wireframe);
    this.lensButton?.setAttribute("aria-pressed", this.engine.camera().orthographic);
  }
}

/** Resolves after a time in which the page was visible: hidden pages do not draw. */
async function whileSeen(milliseconds) {
  do {
    await new Promise((done) => setTimeout(done, milliseconds));
  } while (document.hidden);
}

/** Splits properties of a node into plain values and arrays. */
function splitArrays({ op, id, parent, kind, ...props }, arrays) {
  const changedArrays = {};
  for (const name of ARRAYS_OF_NODES) {
    if (typeof props[name] === "number") changedArrays[name] = arrays[props[name]].data;
    else if (props[name] === null) changedArrays[name] = null; // removed
    delete props[name];
  }
  return [props, changedArrays];
}
