/** Ctrl+K: searchable list of all commands. */
class Palette {
  constructor(dialog, commands) {
    Object.assign(this, { dialog, commands });
    this.input = make("input", {
      type: "text", role: "combobox", placeholder: "Search commands …", "aria-label": "Search commands", "aria-expanded": "true",
      "aria-controls": "palette-list", "aria-autocomplete": "list", autocomplete: "off", spellcheck: "false",
    });
    this.list = make("ul", { id: "palette-list", role: "listbox", "aria-label": "Commands" });
    this.nothing = make("p", { class: "dim", role: "status" }, "No matching command.");
    dialog.append(make("div", { class: "palette-field" }, icon("search"), this.input), this.list, this.nothing);
    this.input.addEventListener("input", () => this.filter());
    this.input.addEventListener("keydown", (event) => this.onKey(event));
    this.list.addEventListener("click", (event) => this.choose(event.target.closest("li")?.dataset.index));
    this.list.addEventListener("pointermove", (event) => {
      const index = event.target.closest("li")?.dataset.index;
      if (index !== undefined && Number(index) !== this.active) this.activate(Number(index), false);
    });
    dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  }

  open() {
    if (this.dialog.open) return this.dialog.close();
    this.input.value = "";
    this.filter();
    this.dialog.showModal();
    this.input.focus();
  }

  refresh() {
    if (!this.dialog.open) return;
    const chosen = this.matches[this.active]?.command.label;
    this.filter();
    this.activate(Math.max(0, this.matches.findIndex(({ command }) => command.label === chosen)));
  }

  filter() {
    const words = this.input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const all = this.commands.list({ withPanel: true });
    this.matches = all.map((command) => ({ command, rank: rankOf(command, words) })).filter(({ rank }) => rank > 0);
    if (words.length > 0) this.matches.sort((a, b) => b.rank - a.rank);
    this.list.replaceChildren(...this.matches.map(({ command }, index) => this.makeRow(command, index)));
    this.list.hidden = this.matches.length === 0;
    this.nothing.hidden = this.matches.length > 0;
    this.activate(0);
  }

  makeRow({ label, group, keys }, index) {
    const shown = make("span", { class: "keys" }, ...keys.slice(0, 3).map((key) => make("kbd", {}, shownKey(key))));
    const row = make("li", { role: "option", id: `palette-${index}` }, make("span", { class: "dim group" }, group), make("span", { class: "label" }, label), shown);
    row.dataset.index = index;
    return row;
  }

  activate(index, scroll = true) {
    this.active = index;
    [...this.list.children].forEach((row, k) => row.setAttribute("aria-selected", k === index));
    const row = this.list.children[index];
    if (row) this.input.setAttribute("aria-activedescendant", row.id);
    else this.input.removeAttribute("aria-activedescendant");
    if (row && scroll) row.scrollIntoView({ block: "nearest" });
  }

  onKey(event) {
    if (!this.dialog.open) return; // the focus is still here for a moment
    const count = this.matches.length;
    const moves = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 };
    if (event.key in moves && count > 0) {
      const by = moves[event.key];
      this.activate(Math.abs(by) === 1 ? (this.active + by + count) % count : clamp(this.active + by, 0, count - 1));
    } else if (event.key === "Enter") this.choose(this.active);
    else if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "k") this.dialog.close();
    else return;
    event.preventDefault();
  }

  choose(index) {
    const command = this.matches[Number(index)]?.command;
    if (index === undefined || !command) return;
    this.dialog.close();
    command.run();
  }
}

/** Match score of a command, 0 for none: all words must occur; matches at the start of the label score highest. */
function rankOf({ label, group }, words) {
  const [name, home] = [label.toLowerCase(), group.toLowerCase()];
  let rank = 1;
  for (const word of words) {
    if (name.startsWith(word)) rank += 8;
    else if (name.includes(` ${word}`)) rank += 4;
    else if (name.includes(word)) rank += 2;
    else if (home.includes(word)) rank += 1;
    else return 0;
  }
  return rank;
}

/** H or ?: mouse and touch gestures, and all commands with their keys. */
const GESTURES = [
  ["drag", "rotate"],
  ["right drag, Shift + drag, two fingers", "move"],
  ["wheel, two fingers apart", "nearer, farther"],
  ["double click", "rotate about this point"],
];

class Help {
  constructor(dialog, commands) {
    Object.assign(this, { dialog, commands });
    const close = iconButton("close", "Close (Esc)", () => dialog.close());
    this.body = make("div", { class: "help-body", tabindex: 0 });
    dialog.append(make("header", {}, make("h2", { id: "help-title" }, "Keys and commands"), close), this.body);
    dialog.setAttribute("aria-labelledby", "help-title");
    dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
    dialog.addEventListener("keydown", (event) => {
      if (event.key !== "h" && event.key !== "H" && event.key !== "?") return;
      event.preventDefault();
      dialog.close();
    });
  }

  open() {
    if (this.dialog.open) return this.dialog.close();
    const groups = new Map();
    for (const command of this.commands.list()) {
      if (!groups.has(command.group)) groups.set(command.group, []);
      groups.get(command.group).push(command);
    }
    const sections = [...groups].map(([group, commands]) => this.makeSection(group, commands));
    this.body.replaceChildren(this.makeGestures(), ...sections);
    this.dialog.showModal();
    this.body.focus();
  }

  makeGestures() {
    const rows = GESTURES.flatMap(([gesture, does]) => [make("dt", {}, gesture), make("dd", {}, does)]);
    return make("section", {}, make("h3", {}, "Mouse and fingers"), make("dl", {}, ...rows));
  }

  makeSection(group, commands) {
    const sorted = [...commands].sort((a, b) => (b.keys.length > 0) - (a.keys.length > 0));
    const rows = sorted.flatMap(({ label, keys }) => [
      make("dt", {}, ...(keys.length ? keys.map((key) => make("kbd", {}, shownKey(key))) : [make("span", { class: "dim" }, "–")])),
      make("dd", {}, label),
    ]);
    return make("section", {}, make("h3", {}, group), make("dl", {}, ...rows));
  }
}
