/**
 * Rows of a tree without their display: labels are split at "/" into groups. Visible rows are one list, rebuilt when
 * rows change; counts are rebuilt when checkboxes change.
 */
const OPEN_UP_TO = 60; // maximum number of rows of an initially open group

class TreeRows {
  constructor() {
    this.rows = new Map(); // by key: { key, label, visible, color }
    this.opened = new Map(); // groups by path, opened or closed by the user
    this.filter = "";
    this.root = null;
    this.list = null;
  }

  put(rows) {
    for (const [key, label, visible, color] of rows) {
      const before = this.rows.get(key);
      if (before && before.label === label) Object.assign(before, { visible, color });
      else {
        this.rows.set(key, { key, label, visible, color });
        this.root = null;
      }
    }
    this.list = null;
  }

  drop(keys) {
    for (const key of keys) if (this.rows.delete(key)) this.root = null;
    this.list = null;
  }

  setFilter(text) {
    this.filter = text.trim().toLowerCase();
    this.list = null;
  }

  /** Rows that pass the filter. */
  matching() {
    const words = this.filter.split(/\s+/).filter(Boolean);
    const rows = [...this.rows.values()];
    if (words.length === 0) return rows;
    return rows.filter(({ label }) => words.every((word) => label.toLowerCase().includes(word)));
  }

  isOpen(group) {
    if (this.filter !== "") return this.opened.get(`${group.path}?`) ?? true;
    return this.opened.get(group.path) ?? (group.total <= OPEN_UP_TO || group.isOnly);
  }

  toggle(group, open = !this.isOpen(group)) {
    this.opened.set(this.filter === "" ? group.path : `${group.path}?`, open);
    this.list = null;
  }

  /** Displayed rows from top to bottom: `{ depth, name, row }` or `{ depth, name, group }`. */
  visibleRows() {
    if (this.list) return this.list;
    const root = grow(this.matching());
    tally(root);
    this.root = root;
    this.list = [];
    const visit = (group, depth) => {
      for (const inner of group.groups.values()) inner.isOnly = group.groups.size + group.leaves.length === 1;
      const all = [...group.groups.values()].map((inner) => ({ name: inner.name, inner })).concat(group.leaves);
      all.sort((a, b) => byName(a.name, b.name));
      all.forEach(({ name, inner, row }, index) => {
        this.list.push({ depth, name, row, group: inner, position: index + 1, of: all.length });
        if (inner && this.isOpen(inner)) visit(inner, depth + 1);
      });
    };
    visit(root, 0);
    return this.list;
  }

  /** Keys of a group that differ from the wanted state. */
  keysToSet(group, visible) {
    const keys = [];
    const visit = ({ groups, leaves }) => {
      for (const { row } of leaves) if (row.visible !== visible) keys.push(row.key);
      for (const inner of groups.values()) visit(inner);
    };
    visit(group);
    return keys;
  }

  set(keys, visible) {
    for (const key of keys) {
      const row = this.rows.get(key);
      if (row) row.visible = visible;
    }
    if (this.root) tally(this.root);
  }
}

function grow(rows) {
  const root = { name: "", path: "", groups: new Map(), leaves: [], total: 0, shown: 0 };
  for (const row of rows) {
    const parts = row.label.split("/").filter((part) => part !== "");
    const name = parts.pop() ?? row.label;
    let group = root;
    for (const part of parts) {
      let inner = group.groups.get(part);
      if (!inner) {
        inner = { name: part, path: `${group.path}/${part}`, groups: new Map(), leaves: [], total: 0, shown: 0 };
        group.groups.set(part, inner);
      }
      group = inner;
    }
    group.leaves.push({ name, row });
  }
  return root;
}

/** Number of rows and of visible rows per group. */
function tally(group) {
  group.total = group.leaves.length;
  group.shown = 0;
  for (const { row } of group.leaves) if (row.visible) group.shown += 1;
  for (const inner of group.groups.values()) {
    tally(inner);
    group.total += inner.total;
    group.shown += inner.shown;
  }
}

const collator = new Intl.Collator(undefined, { numeric: true });

function byName(a, b) {
  return collator.compare(a, b);
}
