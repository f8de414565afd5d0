/** Base class of controls: a row of the panel, label, state, and sent values. */
class Control {
  /** `panel` offers `sendValue`, `press`, `notify`; `build` makes the elements, `update` shows values of the program. */
  constructor(op, panel) {
    this.id = op.id;
    this.kind = op.kind;
    this.panel = panel;
    this.props = {};
    this.field = `control-${op.id}`;
    this.element = make("div", { class: `control ${op.kind}` });
    this.element.dataset.control = op.id;
    this.name = make("label", { for: this.field, class: "name" });
    this.build(op);
  }

  build() {}

  update() {}

  /** Applies fields set by the program; missing fields are not changed. */
  set(changes) {
    if (changes.value === undefined) delete changes.value; // unchanged
    Object.assign(this.props, changes);
    const { label, visible, hint, disabled } = this.props;
    this.element.hidden = visible === false;
    if ("label" in changes) this.setLabel(label ?? "");
    if ("hint" in changes) this.setHint(hint ?? "");
    this.update(changes);
    if ("disabled" in changes || this.props.disabled) this.setDisabled(Boolean(disabled));
  }

  setLabel(label) {
    this.name.textContent = label;
    this.name.hidden = label === "";
    for (const element of this.inputs()) {
      if (label === "") element.setAttribute("aria-label", this.kind);
      else element.removeAttribute("aria-label");
    }
  }

  setHint(hint) {
    if (hint) this.element.title = hint;
    else this.element.removeAttribute("title");
    for (const element of this.inputs()) {
      if (hint) element.setAttribute("aria-description", hint);
      else element.removeAttribute("aria-description");
    }
  }

  setDisabled(disabled) {
    this.element.classList.toggle("disabled", disabled);
    for (const element of this.inputs()) element.disabled = disabled;
  }

  inputs() {
    return this.element.querySelectorAll("input, select, button, textarea");
  }

  /** Entries for the palette: `[label, run]`. */
  actions() {
    return [];
  }

  send(value) {
    this.props.value = value;
    this.panel.sendValue(this.id, value);
  }

  /** Removes the control with what it has outside its element. */
  remove() {
    this.element.remove();
  }
}

/** A folder that opens and closes; without a label it only groups controls. */
class FolderControl extends Control {
  build(op) {
    this.title = make("span", { class: "title" });
    this.body = make("div", { class: "folder-body" });
    this.isPlain = op.label === null || op.label === undefined;
    if (this.isPlain) {
      this.element.append(this.body);
      return;
    }
    const details = make("details", {}, make("summary", {}, icon("folder"), this.title), this.body);
    this.element.append(details);
    this.details = details;
    details.addEventListener("toggle", () => {
      if (details.open !== this.isOpen) this.panel.rememberFolder(this, details.open);
      this.isOpen = details.open;
    });
  }

  setLabel(label) {
    this.title.textContent = label;
  }

  setDisabled() {}

  inputs() {
    return [];
  }

  update(changes) {
    if (!this.details || !("open" in changes || "label" in changes)) return;
    this.isOpen = this.panel.recallFolder(this) ?? this.props.open !== false;
    this.details.open = this.isOpen;
  }

  /** Path of labels: folders of the same path stay open after a reconnection. */
  path() {
    const parent = this.panel.controls.get(this.props.parent);
    return `${parent?.path?.() ?? ""}/${this.props.label ?? ""}`;
  }
}
