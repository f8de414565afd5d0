/**
 * Key bindings: commands of the program, then of the page. Keys that a focused control uses stay with it. Key names:
 * "R", "7", "plus", "Shift+P", "escape", "arrowup".
 */
const KEY_NAMES = { " ": "space", "+": "plus" };
const SHOWN_KEYS = {
  space: "Space", plus: "+", "-": "−", escape: "Esc", enter: "Enter", backspace: "Backspace", delete: "Delete", insert: "Insert",
  tab: "Tab", home: "Home", end: "End", pageup: "Page up", pagedown: "Page down",
  arrowup: "↑", arrowdown: "↓", arrowleft: "←", arrowright: "→",
};
const USED_BY = {
  text: () => true,
  select: (key) => !/^(escape)$/.test(key),
  range: (key) => /^(arrow|home|end|page)/.test(key),
  press: (key) => key === "space" || key === "enter",
  box: (key) => key === "space",
};

/** Name of a key as in `hotkey`; null for keys of the browser. */
function keyName(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return null;
  const { key } = event;
  const name = KEY_NAMES[key] ?? (key.length === 1 ? key.toUpperCase() : key.toLowerCase());
  const isLetter = name.length === 1 && name.toLowerCase() !== name;
  return event.shiftKey && (isLetter || name.length > 1) && name !== "plus" ? `Shift+${name}` : name;
}

function shownKey(hotkey) {
  return hotkey
    .split("+")
    .map((part) => SHOWN_KEYS[part.toLowerCase()] ?? (part.length === 1 ? part.toUpperCase() : part))
    .filter((part) => part !== "")
    .join(" + ");
}

function controlKind(element) {
  const tag = element?.tagName;
  if (tag === "SELECT") return "select";
  if (tag === "BUTTON" || tag === "SUMMARY" || tag === "A") return "press";
  if (tag === "TEXTAREA" || element?.isContentEditable) return "text";
  if (tag !== "INPUT") return null;
  if (element.type === "range") return "range";
  if (element.type === "checkbox" || element.type === "radio") return "box";
  return element.type === "color" || element.type === "file" ? "press" : "text";
}

class Commands {
  constructor({ send, panel }) {
    Object.assign(this, { send, panel });
    this.ofProgram = new Map(); // by id
    this.registered = []; // { keys, label, group, run, isThere }
    document.addEventListener("keydown", (event) => this.onKey(event));
  }

  add({ id, label, hotkey, group }) {
    this.ofProgram.set(id, { id, label, keys: hotkey ? [hotkey] : [], group: group || "Viewer" });
  }

  drop(id) {
    this.ofProgram.delete(id);
  }

  clear() {
    this.ofProgram.clear();
  }

  addOwn(group, label, keys, run, isThere = () => true) {
    const named = keys.map((key) => (key === "+" ? "plus" : key.replace("Arrow", "arrow")));
    this.registered.push({ group: capitalized(group), label: capitalized(label), keys: named, run, isThere });
  }

  onKey(event) {
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const name = keyName(event);
    if (name === null) return this.onChord(event);
    const kind = controlKind(event.target);
    if (kind && USED_BY[kind](name)) return this.leaveField(event, kind, name);
    const run = this.find(name);
    if (!run) return;
    event.preventDefault();
    run();
  }

  /** Ctrl+K; other chords belong to the browser. */
  onChord(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== "k") return;
    event.preventDefault();
    this.find("Ctrl+K")();
  }

  leaveField(event, kind, name) {
    if (kind === "text" && name === "escape" && !event.defaultPrevented) event.target.blur();
  }

  isTaken(key) {
    const name = key === "+" ? "plus" : key;
    return [...this.ofProgram.values()].some(({ keys }) => keys.some((one) => sameKey(one, name)));
  }

  find(name) {
    for (const command of this.ofProgram.values()) {
      if (command.keys.some((key) => sameKey(key, name))) return () => this.runProgram(command);
    }
    return this.registered.find(({ keys, isThere }) => keys.some((key) => sameKey(key, name)) && isThere())?.run;
  }

  runProgram({ id }) {
    this.panel.sayPending();
    this.send({ say: "command", id });
  }

  /**
   * All that can be done, each once: commands with the same words are one with all their keys. A key that does another
   * thing first is not named.
   */
  list({ withPanel = false } = {}) {
    const merged = new Map();
    const taken = new Set();
    const put = ({ label, group, keys, run }, isKeyed) => {
      const id = plainLabel(label).toLowerCase();
      const known = merged.get(id) ?? { label: capitalized(plainLabel(label)), group, keys: [], run };
      for (const key of keys) {
        const name = key.toLowerCase();
        if (!taken.has(name) && isKeyed) known.keys.push(key);
        taken.add(name);
      }
      merged.set(id, known);
    };
    for (const command of this.ofProgram.values()) put({ ...command, run: () => this.runProgram(command) }, true);
    for (const command of this.registered) if (command.isThere()) put(command, true);
    if (withPanel) for (const action of this.panel.actions()) put({ ...action, keys: [] }, false);
    return [...merged.values()];
  }
}

function capitalized(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function sameKey(key, name) {
  return key.toLowerCase() === name.toLowerCase();
}

/** A label without a key name at its end: "Reset view (R)". */
function plainLabel(label) {
  return label.replace(/\s*\((?:[^\s()]|Shift\+.)\)$/, "");
}
