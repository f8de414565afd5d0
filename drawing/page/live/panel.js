/**
 * The panel: which controls there are, where they lie, and what is said when they change. A control that stands at the
 * edge of the picture or in the bar lies in no folder.
 */
const CONTROL_KINDS = {
  folder: FolderControl, button: ButtonControl, checkbox: CheckboxControl, slider: SliderControl,
  range: RangeControl, number: NumberControl, text: TextControl, dropdown: DropdownControl, rgb: RgbControl,
  words: WordsControl, table: TableControl, upload: UploadControl,
  colorbar: ColorbarControl, legend: LegendControl, tree: TreeControl, timeline: TimelineControl,
};

class Panel {
  /** `root`, `keys`, `bar` are where controls lie; `send` says something; `notify` shows words; `changed` is told of new rooms. */
  constructor({ root, keys, bar, send, notify, changed, isBusy }) {
    Object.assign(this, { root, keys, bar, send, notify, changed, isBusy });
    this.controls = new Map();
    this.folders = new Map(); // by path: whether somebody opened or closed it
    this.pending = new Map();
    this.held = null; // the control whose track somebody drags
    this.late = new Map(); // what the program set meanwhile
    this.listenToTracks();
    this.flush = onceAPicture(() => this.sayPending());
  }

  listenToTracks() {
    document.addEventListener("pointerdown", ({ target }) => {
      if (target.type === "range") this.held = Number(target.closest("[data-control]")?.dataset.control);
    });
    for (const kind of ["pointerup", "pointercancel"]) document.addEventListener(kind, () => this.letGo());
  }

  /** What the program set while a track was dragged is shown, where nothing was said after it. */
  letGo() {
    this.held = null;
    for (const [id, value] of this.late) this.controls.get(id)?.set({ value });
    this.late.clear();
  }

  // -- what the program says ------------------------------------------------------------------------------------------

  add(op, arrays) {
    const type = CONTROL_KINDS[op.kind];
    if (!type) return;
    this.drop(op.id);
    const control = new type(op, this);
    this.controls.set(op.id, control);
    control.props = { parent: op.parent, order: op.order };
    control.set(readArrays(op, arrays));
    this.place(control);
  }

  set(op, arrays) {
    const control = this.controls.get(op.id);
    if (!control) return;
    if ("value" in op && (this.held === op.id || this.pending.has(op.id))) {
      if (this.held === op.id) this.late.set(op.id, op.value); // not while somebody drags it
      op = { ...op, value: undefined };
    }
    control.set(readArrays(op, arrays));
    if ("order" in op || "parent" in op) this.place(control);
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
    this.tellEmpty();
  }

  clear() {
    for (const id of [...this.controls.keys()]) this.drop(id);
  }

  /** Puts a control where its order says; without one, behind those that came before. */
  place(control) {
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
    this.tellEmpty();
    if (host === this.bar) this.onBarChanged();
    if (host === this.keys) this.onKeysChanged();
  }

  hostOf(control) {
    if (control.kind === "timeline") return this.bar;
    if (control.kind === "colorbar" || control.kind === "legend") return this.keys;
    return this.controls.get(control.props.parent)?.body ?? this.root;
  }

  tellEmpty() {
    const isEmpty = this.root.children.length === 0;
    if (isEmpty === this.isEmpty) return;
    this.isEmpty = isEmpty;
    this.changed();
  }

  // -- what the page says ---------------------------------------------------------------------------------------------

  /** The last value of each control, once a picture. */
  sayValue(id, value) {
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
    return this.send({ say: "file", id, name, text }, MOST_FILE);
  }

  // -- what controls ask for ------------------------------------------------------------------------------------------

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

  /** The time line that keys move, where there is one to be seen. */
  get timeline() {
    return [...this.controls.values()].find((control) => control.kind === "timeline" && !control.element.hidden && !control.props.disabled);
  }

  /** What can be pressed, for the palette: `{ label, group, run }`. */
  actions() {
    const found = [];
    for (const control of this.controls.values()) {
      if (!this.isReachable(control)) continue;
      for (const [label, run] of control.actions()) if (label) found.push({ label, group: this.groupOf(control), run });
    }
    return found;
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

/** `colors` names an array: replaced by the array itself. */
function readArrays(op, arrays) {
  return typeof op.colors === "number" ? { ...op, colors: arrays[op.colors] } : { ...op };
}
