/** What all controls share: a row of the panel, its label, its state, and what is said when it is changed. */
class Control {
  /** `panel` offers `say`, `press`, `notify`; `build` makes the elements, `update` shows what the program set. */
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

  /** Takes what the program sets; fields that it does not name stay. */
  set(changes) {
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

  /** The elements that take the focus. */
  inputs() {
    return this.element.querySelectorAll("input, select, button, textarea");
  }

  /** What the palette offers of this control: `[label, run]`. */
  actions() {
    return [];
  }

  say(value) {
    this.props.value = value;
    this.panel.sayValue(this.id, value);
  }

  /** It goes: what it holds outside its element goes, too. */
  remove() {
    this.element.remove();
  }
}

/** A part of the panel that opens and closes; without a label it only holds others together. */
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

  /** Where it lies, by labels: folders of the same place stay open when the page connects again. */
  path() {
    const parent = this.panel.controls.get(this.props.parent);
    return `${parent?.path?.() ?? ""}/${this.props.label ?? ""}`;
  }
}
