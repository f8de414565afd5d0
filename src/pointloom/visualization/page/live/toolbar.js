/** Row of icons at the top: one tab stop, arrow keys within; menus open below. */
class Toolbar {
  constructor(root) {
    this.root = root;
    root.addEventListener("keydown", (event) => this.onKey(event));
    root.addEventListener("focusin", (event) => this.rove(event.target));
  }

  get buttons() {
    return [...this.root.querySelectorAll(":scope > button, :scope > .menu > button")].filter((button) => button.offsetParent !== null);
  }

  add(name, label, run, { key = null, narrow = false } = {}) {
    const title = key ? `${label} (${shownKey(key)})` : label;
    const button = iconButton(name, label, run, { title, class: narrow ? "icon" : "icon wide-only", tabindex: -1 });
    if (key) button.setAttribute("aria-keyshortcuts", key.replace("Ctrl", "Control"));
    this.root.append(button);
    if (this.root.querySelectorAll('[tabindex="0"]').length === 0) button.tabIndex = 0;
    return button;
  }

  addMenu(name, label, entries, options = {}) {
    const menu = new Menu(name, label, entries, options);
    this.root.append(menu.element);
    return menu;
  }

  addGap() {
    this.root.append(make("span", { class: "gap wide-only", role: "separator" }));
  }

  rove(target) {
    if (!this.buttons.includes(target)) return;
    for (const button of this.buttons) button.tabIndex = button === target ? 0 : -1;
  }

  onKey(event) {
    if (event.defaultPrevented) return;
    const { buttons } = this;
    const index = buttons.indexOf(document.activeElement);
    const next = { ArrowRight: index + 1, ArrowLeft: index - 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (index < 0 || next === undefined) return;
    event.preventDefault();
    buttons[(next + buttons.length) % buttons.length].focus();
  }
}

/** Menu below an icon; `entries` are `[label, run, isOn?]`, null is a separator. */
class Menu {
  constructor(name, label, entries, { narrow = false } = {}) {
    this.entries = entries;
    this.button = iconButton(name, label, () => this.toggle(), { "aria-haspopup": "menu", "aria-expanded": "false", tabindex: -1 });
    this.list = make("div", { class: "menu-list", role: "menu", "aria-label": label, hidden: true });
    this.element = make("div", { class: narrow ? "menu" : "menu wide-only" }, this.button, this.list);
    this.element.addEventListener("keydown", (event) => this.onKey(event));
    this.element.addEventListener("focusout", (event) => {
      if (!this.element.contains(event.relatedTarget)) this.close();
    });
  }

  toggle() {
    if (this.list.hidden) this.open();
    else this.close();
  }

  open() {
    this.list.replaceChildren(...this.entries.map((entry) => this.makeEntry(entry)));
    this.list.hidden = false;
    this.button.setAttribute("aria-expanded", "true");
    const { right } = this.list.getBoundingClientRect();
    this.list.style.translate = right > innerWidth - 8 ? `${innerWidth - 8 - right}px 0` : "";
    this.items[0].focus();
  }

  get items() {
    return [...this.list.querySelectorAll("button")];
  }

  makeEntry(entry) {
    if (entry === null) return make("hr");
    const [label, run, isOn] = entry;
    const item = make("button", { type: "button", role: isOn ? "menuitemradio" : "menuitem", tabindex: -1 }, label);
    if (isOn) item.setAttribute("aria-checked", isOn());
    item.addEventListener("click", () => {
      this.close();
      this.button.focus();
      run();
    });
    return item;
  }

  close() {
    if (this.list.hidden) return;
    this.list.hidden = true;
    this.list.style.translate = "";
    this.button.setAttribute("aria-expanded", "false");
  }

  onKey(event) {
    if (this.list.hidden) {
      if (event.key !== "ArrowDown") return;
      event.preventDefault();
      return this.open();
    }
    const { items } = this;
    const index = items.indexOf(document.activeElement);
    const next = { ArrowDown: index + 1, ArrowUp: index - 1, Home: 0, End: items.length - 1 }[event.key];
    if (event.key === "Escape") {
      this.close();
      this.button.focus();
    } else if (next !== undefined) items[(next + items.length) % items.length].focus();
    else return;
    event.preventDefault();
  }
}
