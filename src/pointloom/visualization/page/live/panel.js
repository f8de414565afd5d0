/**
 * The panel: its controls, their placement, and sent values. Controls at the image edge or in the bar are in no folder.
 */
const CONTROL_KINDS = {
  folder: FolderControl, button: ButtonControl, checkbox: CheckboxControl, slider: SliderControl,
  range: RangeControl, number: NumberControl, text: TextControl, dropdown: DropdownControl, rgb: RgbControl,
  words: WordsControl, table: TableControl, upload: UploadControl,
  colorbar: ColorbarControl, legend: LegendControl, tree: TreeControl, timeline: TimelineControl,
};

class Panel {
  /** `root`, `keys`, `bar`: parents of controls; `send`, `notify`: functions; `changed`: called after a layout change. */
  constructor({ root, keys, bar, send, notify, changed, isBusy }) {
    Object.assign(this, { root, keys, bar, send, notify, changed, isBusy });
    this.controls = new Map();
    this.folders = new Map(); // by path: opened or closed by the user
    this.pending = new Map();
    this.dragged = null; // control being dragged
    this.late = new Map(); // values set by the program meanwhile
    this.listenToTracks();
    this.flush = onceAPicture(() => this.sayPending());
  }

  listenToTracks() {
    document.addEventListener("pointerdown", ({ target }) => {
      if (target.type === "range") this.dragged = Number(target.closest("[data-control]")?.dataset.control);
    });
    for (const kind of ["pointerup", "pointercancel"]) document.addEventListener(kind, () => this.letGo());
  }

  /** Shows values of the program that were set during a drag, unless the page sent a newer one. */
  letGo() {
    this.dragged = null;
    for (const [id, value] of this.late) this.controls.get(id)?.set({ value });
    this.late.clear();
  }

  add(op, arrays) {
    const type = CONTROL_KINDS[op.kind];
    if (!type) return;
    this.drop(op.id);
    const control = new type(op, this);
    this.controls.set(op.id, control);
    control.props = { parent: op.parent, order: op.order };
    control.set(readArrays(op, arrays));
    this.insert(control);
  }

  set(op, arrays) {
    const control = this.controls.get(op.id);
    if (!control) return;
    if ("value" in op && (this.dragged === op.id || this.pending.has(op.id))) {
      if (this.dragged === op.id) this.late.set(op.id, op.value); // not while being dragged
      op = { ...op, value: undefined };
    }
    control.set(readArrays(op, arrays));
    if ("order" in op || "parent" in op) this.insert(control);
  }

  rows(op) {
    this.controls.get(op.id)?.apply?.(op);
  }

  drop(id) {
    const control = this.controls.get(id);
    if (!control) return;
    for (const inner of [...this.controls.values()]) if (inner.props.parent === id && inner !== control) this.drop(inner.id);
    this.controls.delete(id);
    this.pending.delete(id);
    control.remove();
    this.reportEmpty();
  }

  clear() {
    for (const id of [...this.controls.keys()]) this.drop(id);
  }

  /** Inserts a control by its order; without one, after the existing ones. */
  insert(control) {
    const host = this.hostOf(control);
    const rank = ({ props, id }) => [props.order ?? Infinity, id];
    const [order, id] = rank(control);
    const next = [...host.children].find((element) => {
      const other = this.controls.get(Number(element.dataset.control));
      if (!other || other === control) return false;
      const [otherOrder, otherId] = rank(other);
      return otherOrder > order || (otherOrder === order && otherId > id);
    });
    host.insertBefore(control.element, next ?? null);
    this.reportEmpty();
    if (host === this.bar) this.onBarChanged();
    if (host === this.keys) this.onKeysChanged();
  }

  hostOf(control) {
    if (control.kind === "timeline") return this.bar;
    if (control.kind === "colorbar" || control.kind === "legend") return this.keys;
    return this.controls.get(control.props.parent)?.body ?? this.root;
  }

  reportEmpty() {
    const isEmpty = this.root.children.length === 0;
    if (isEmpty === this.isEmpty) return;
    this.isEmpty = isEmpty;
    this.changed();
  }

  /** Sends the last value of each control once per frame. */
  sendValue(id, value) {
    this.pending.set(id, value);
    this.late.delete(id);
    this.flush();
  }

  sayPending() {
    const values = [...this.pending];
    this.pending.clear();
    for (const [id, value] of values) this.send({ say: "value", id, value });
  }

  sayNow(id, value) {
    this.sayPending();
    return this.send({ say: "value", id, value });
  }

  press(id) {
    this.sayPending();
    this.send({ say: "press", id });
  }

  sayFile(id, name, text) {
    this.sayPending();
    return this.send({ say: "file", id, name, text }, MAX_FILE);
  }

  recallFolder(folder) {
    return this.folders.get(folder.path());
  }

  rememberFolder(folder, open) {
    this.folders.set(folder.path(), open);
  }

  onKeysChanged() {
    this.keys.hidden = ![...this.keys.children].some((element) => !element.hidden);
    this.changed();
  }

  onBarChanged() {
    this.bar.hidden = ![...this.bar.children].some((element) => !element.hidden);
    this.changed();
  }

  /** The visible timeline for keys, if any. */
  get timeline() {
    return [...this.controls.values()].find((control) => control.kind === "timeline" && !control.element.hidden && !control.props.disabled);
  }

  /** Actions for the palette: `{ label, group, run }`. */
  actions() {
    const entries = [];
    for (const control of this.controls.values()) {
      if (!this.isReachable(control)) continue;
      for (const [label, run] of control.actions()) if (label) entries.push({ label, group: this.groupOf(control), run });
    }
    return entries;
  }

  isReachable(control) {
    for (let one = control; one; one = this.controls.get(one.props.parent)) {
      if (one.props.visible === false || one.props.disabled) return false;
    }
    return true;
  }

  groupOf(control) {
    for (let one = this.controls.get(control.props.parent); one; one = this.controls.get(one.props.parent)) {
      if (one.props.label) return one.props.label;
    }
    return "Panel";
  }
}

/** Replaces the name in `colors` by the array. */
function readArrays(op, arrays) {
  return typeof op.colors === "number" ? { ...op, colors: arrays[op.colors] } : { ...op };
}
