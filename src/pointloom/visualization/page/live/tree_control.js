/** The tree of names: a filter, all or none, and elements only for the rows in view. */
const TREE_ROW = 28; // [px]; as in the style sheet
const TREE_ROW_TOUCH = 44;
const MAX_ROWS = 13; // rows visible at once
const SPARE = 6; // extra rows beyond both edges
const MAX_KEYS = 48 * 1024; // bytes of keys per message

class TreeControl extends Control {
  build() {
    this.rows = new TreeRows();
    this.active = 0;
    this.filter = make("input", { type: "search", placeholder: "Filter", "aria-label": "Filter names", autocomplete: "off", spellcheck: "false", id: this.field });
    this.all = make("button", { type: "button" }, "All");
    this.none = make("button", { type: "button" }, "None");
    this.count = make("span", { class: "dim count", role: "status" });
    this.list = make("div", { class: "tree-rows", role: "group" });
    this.box = make("div", { class: "tree-box", role: "tree", tabindex: 0, "aria-label": "Displayed geometries", "aria-multiselectable": "true" }, this.list);
    this.head = make("div", { class: "tree-head" }, this.filter, this.all, this.none);
    this.element.append(this.name, this.head, this.box, this.count);
    this.draw = onceAPicture(() => this.render());
    this.filter.addEventListener("input", () => this.onFilter());
    this.filter.addEventListener("keydown", (event) => {
      if (event.key === "ArrowDown") this.box.focus();
      else if (event.key === "Escape" && this.filter.value !== "") this.filter.value = "";
      else return;
      event.preventDefault();
      event.stopPropagation();
      this.onFilter();
    });
    this.all.addEventListener("click", () => this.setAll(true));
    this.none.addEventListener("click", () => this.setAll(false));
    this.box.addEventListener("scroll", this.draw, { passive: true });
    this.box.addEventListener("keydown", (event) => this.onKey(event));
    this.box.addEventListener("focus", this.draw);
    this.box.addEventListener("blur", this.draw);
    this.list.addEventListener("click", (event) => this.onClick(event));
    this.watcher = new ResizeObserver(() => this.draw());
    this.watcher.observe(this.box);
  }

  setLabel(label) {
    this.name.textContent = label;
    this.name.hidden = label === "";
    if (label) this.box.setAttribute("aria-label", label);
  }

  apply({ put = [], drop = [] }) {
    this.rows.drop(drop);
    this.rows.put(put);
    this.draw();
  }

  get rowHeight() {
    return matchMedia("(pointer: coarse)").matches ? TREE_ROW_TOUCH : TREE_ROW;
  }

  onFilter() {
    this.rows.setFilter(this.filter.value);
    this.active = 0;
    this.box.scrollTop = 0;
    this.draw();
  }

  setAll(visible) {
    this.rows.visibleRows();
    this.sendVisibility(this.rows.keysToSet(this.rows.root, visible), visible);
  }

  toggle({ row, group }) {
    if (row) return this.sendVisibility([row.key], !row.visible);
    const visible = group.shown < group.total;
    this.sendVisibility(this.rows.keysToSet(group, visible), visible);
  }

  /** A message is limited to 64 KiB: thousands of keys are sent in several. */
  sendVisibility(keys, visible) {
    if (keys.length === 0) return;
    this.rows.set(keys, visible);
    this.render(); // at once: screen readers read the new state with the press
    let [part, size] = [[], 0];
    for (const key of keys) {
      const bytes = 3 * String(key).length + 4;
      if (size + bytes > MAX_KEYS) {
        this.panel.sayNow(this.id, [part, visible]);
        [part, size] = [[], 0];
      }
      part.push(key);
      size += bytes;
    }
    this.panel.sayNow(this.id, [part, visible]);
  }

  onClick(event) {
    const element = event.target.closest("[data-index]");
    if (!element || this.props.disabled) return;
    this.active = Number(element.dataset.index);
    const entry = this.rows.visibleRows()[this.active];
    if (!entry) return;
    if (entry.group && !event.target.closest(".tick")) this.rows.toggle(entry.group);
    else this.toggle(entry);
    this.draw();
  }

  onKey(event) {
    const seen = this.rows.visibleRows();
    const page = Math.max(1, Math.floor(this.box.clientHeight / this.rowHeight) - 1);
    const moves = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -seen.length, End: seen.length };
    const entry = seen[this.active];
    if (event.ctrlKey || event.metaKey || event.altKey || !entry) return;
    if (moves[event.key]) this.activate(this.active + moves[event.key]);
    else if (event.key === "ArrowRight" && entry.group) {
      if (this.rows.isOpen(entry.group)) this.activate(this.active + 1);
      else this.rows.toggle(entry.group, true);
    } else if (event.key === "ArrowLeft") {
      if (entry.group && this.rows.isOpen(entry.group)) this.rows.toggle(entry.group, false);
      else this.activate(seen.slice(0, this.active).findLastIndex(({ depth }) => depth < entry.depth));
    } else if (event.key === " " || event.key === "Enter") {
      if (!this.props.disabled) this.toggle(entry);
    } else return;
    event.preventDefault();
    event.stopPropagation();
    this.draw();
  }

  activate(index) {
    if (index < 0 && this.active === 0) return;
    this.active = clamp(index, 0, this.rows.visibleRows().length - 1);
    const top = this.active * this.rowHeight;
    const { scrollTop, clientHeight } = this.box;
    if (top < scrollTop) this.box.scrollTop = top;
    else if (top + this.rowHeight > scrollTop + clientHeight) this.box.scrollTop = top + this.rowHeight - clientHeight;
  }

  /** Elements of the rows in view; existing ones are reused. */
  render() {
    const seen = this.rows.visibleRows();
    const height = this.rowHeight;
    this.box.style.setProperty("--row", `${height}px`);
    this.box.style.height = `${Math.min(Math.max(seen.length, 1), MAX_ROWS) * height}px`;
    this.list.style.height = `${seen.length * height}px`;
    this.active = clamp(this.active, 0, Math.max(0, seen.length - 1));
    const first = Math.max(0, Math.floor(this.box.scrollTop / height) - SPARE);
    const wanted = Math.min(seen.length, Math.ceil((this.box.scrollTop + this.box.clientHeight) / height) + SPARE) - first;
    while (this.list.children.length > wanted) this.list.lastChild.remove();
    while (this.list.children.length < wanted) this.list.append(this.makeRow());
    const isFocused = document.activeElement === this.box;
    for (let k = 0; k < wanted; k++) this.fill(this.list.children[k], seen[first + k], first + k, isFocused);
    if (seen.length) this.box.setAttribute("aria-activedescendant", `${this.field}-row-${this.active}`);
    else this.box.removeAttribute("aria-activedescendant");
    this.tellCount();
  }

  tellCount() {
    const { total, shown } = this.rows.root;
    const of = this.rows.filter === "" ? "" : ` · ${countText(total)} of ${countText(this.rows.rows.size)} names`;
    this.count.textContent = this.rows.rows.size === 0 ? "" : total === 0 ? "No matching name" : `${countText(shown)} of ${countText(total)} shown${of}`;
    this.head.hidden = this.rows.rows.size < 2;
    this.count.hidden = this.rows.rows.size < 2;
    this.box.hidden = this.rows.rows.size === 0;
  }

  makeRow() {
    const tick = make("span", { class: "tick", "aria-hidden": "true" });
    const fold = make("span", { class: "fold", "aria-hidden": "true" }, icon("folder"));
    return make("div", { class: "tree-row", role: "treeitem" }, fold, tick, make("i"), make("span", { class: "label" }), make("span", { class: "dim" }));
  }

  fill(element, { depth, name, row, group, position, of }, index, isFocused) {
    const [fold, tick, swatch, label, count] = element.children;
    const state = row ? row.visible : group.shown === group.total ? true : group.shown === 0 ? false : "mixed";
    element.id = `${this.field}-row-${index}`;
    element.dataset.index = index;
    element.style.top = `${index * this.rowHeight}px`;
    element.style.paddingLeft = `${4 + 14 * depth}px`;
    element.title = row ? row.label : `${group.path.slice(1)}/`;
    element.classList.toggle("active", isFocused && index === this.active);
    element.classList.toggle("away", state === false);
    const attributes = { "aria-level": depth + 1, "aria-posinset": position, "aria-setsize": of, "aria-checked": state, "aria-label": name };
    for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value);
    if (group) element.setAttribute("aria-expanded", this.rows.isOpen(group));
    else element.removeAttribute("aria-expanded");
    tick.dataset.state = state;
    fold.classList.toggle("none", !group);
    swatch.hidden = !row?.color;
    if (row?.color) swatch.style.background = cssColor(row.color);
    label.textContent = name;
    count.textContent = group ? (group.shown === group.total ? countText(group.total) : `${countText(group.shown)} / ${countText(group.total)}`) : "";
  }

  remove() {
    this.watcher.disconnect();
    super.remove();
  }
}
