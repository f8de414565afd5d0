/** Buttons, checkboxes, text fields, dropdowns, colors, texts, tables, files. */
class ButtonControl extends Control {
  build() {
    this.button = make("button", { type: "button", id: this.field, class: "wide" });
    this.button.addEventListener("click", () => this.panel.press(this.id));
    this.element.append(this.button);
  }

  setLabel(label) {
    this.button.textContent = label;
  }

  update({ color }) {
    if (color === undefined) return;
    this.button.classList.toggle("tinted", Boolean(color));
    this.button.style.setProperty("--tint", typeof color === "string" ? color : color ? cssColor(color) : "transparent");
  }

  actions() {
    return [[this.props.label ?? "", () => this.button.click()]];
  }
}

class CheckboxControl extends Control {
  build() {
    this.box = make("input", { type: "checkbox", id: this.field });
    this.box.addEventListener("change", () => this.send(this.box.checked));
    this.element.append(this.box, this.name);
  }

  update({ value }) {
    if (value !== undefined) this.box.checked = value;
  }

  actions() {
    return [[this.props.label ?? "", () => this.box.click()]];
  }
}

const TYPING = 300; // [ms] without typing after which a text is sent

class TextControl extends Control {
  build() {
    this.input = make("input", { type: "text", id: this.field, autocomplete: "off", spellcheck: "false" });
    this.input.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.commit(), TYPING);
    });
    this.input.addEventListener("change", () => this.commit());
    this.element.append(this.name, this.input);
  }

  commit() {
    clearTimeout(this.timer);
    this.timer = null;
    if (this.input.value !== this.props.value) this.send(this.input.value);
  }

  /** Keeps unfinished input. */
  update({ value }) {
    if (value !== undefined && !this.timer) this.input.value = value;
  }
}

class DropdownControl extends Control {
  build() {
    this.select = make("select", { id: this.field });
    this.select.addEventListener("change", () => this.send(this.select.value));
    this.element.append(this.name, this.select);
  }

  update({ options, value }) {
    if (options) this.select.replaceChildren(...options.map((option) => make("option", { value: option }, option)));
    if (options || value !== undefined) this.select.value = this.props.value;
  }
}

class RgbControl extends Control {
  build() {
    this.input = make("input", { type: "color", id: this.field });
    this.output = make("span", { class: "dim" });
    this.input.addEventListener("input", () => {
      this.send([1, 3, 5].map((start) => parseInt(this.input.value.slice(start, start + 2), 16)));
      this.output.textContent = this.input.value;
    });
    this.element.append(this.name, make("span", { class: "pair" }, this.output, this.input));
  }

  update({ value }) {
    if (!value) return;
    this.input.value = `#${value.map((part) => clamp(Math.round(part), 0, 255).toString(16).padStart(2, "0")).join("")}`;
    this.output.textContent = this.input.value;
  }
}

class WordsControl extends Control {
  build() {
    this.text = make("p", { class: "text" });
    this.element.append(this.name, this.text);
  }

  update({ value }) {
    if (value === undefined) return;
    this.text.textContent = value;
    this.text.hidden = value === "";
  }
}

class TableControl extends Control {
  build() {
    this.table = make("table");
    this.element.append(this.name, this.table);
  }

  update({ value }) {
    if (!value) return;
    this.table.hidden = value.length === 0;
    const rows = value.map(([label, ...texts]) =>
      make("tr", {}, make("th", { scope: "row" }, String(label)), ...texts.map((text) => make("td", {}, String(text)))),
    );
    this.table.replaceChildren(make("tbody", {}, ...rows));
  }
}

class UploadControl extends Control {
  build() {
    this.input = make("input", { type: "file", hidden: true, tabindex: "-1" });
    this.button = make("button", { type: "button", id: this.field, class: "wide" }, icon("upload"), make("span"));
    this.button.addEventListener("click", () => this.input.click());
    this.input.addEventListener("change", () => this.read());
    this.element.append(this.button, this.input);
  }

  setLabel(label) {
    this.button.lastChild.textContent = label;
    this.input.setAttribute("aria-label", label);
  }

  update({ accept }) {
    if (accept !== undefined) this.input.accept = accept ?? "";
  }

  async read() {
    const [file] = this.input.files;
    this.input.value = ""; // so that the same file can be chosen again
    if (!file) return;
    if (file.size > MAX_FILE) return this.panel.notify("This file is too large", `${file.name}: at most 1 MB can be read here.`);
    try {
      const sent = this.panel.sayFile(this.id, file.name, await file.text());
      if (!sent) this.panel.notify("This file was not sent", `${file.name} is too large, or the program is not connected.`);
    } catch {
      this.panel.notify("This file cannot be read", file.name);
    }
  }

  actions() {
    return [[this.props.label ?? "", () => this.button.click()]];
  }
}
