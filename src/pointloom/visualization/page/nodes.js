/**
 * Tree of nodes: poses are composed in float64, hidden nodes hide their children. A change of a node costs its subtree;
 * the draw list is rebuilt only when nodes are added, removed, shown or hidden.
 */
class SceneNode {
  constructor(id, parent, kind) {
    Object.assign(this, { id, parent, kind, props: {}, geometry: null, label: null });
    this.children = new Set();
    this.pose = IDENTITY;
    this.visible = true;
    this.composed = null;
    parent?.children.add(this);
  }

  get world() {
    this.composed ??= this.parent ? compose(this.parent.world, this.pose) : Float64Array.from(IDENTITY);
    return this.composed;
  }

  setPose(pose) {
    if (pose.length !== 12 || !Array.from(pose).every(Number.isFinite)) return;
    this.pose = pose;
    this.forget();
  }

  forget() {
    if (this.composed === null) return; // then no child has one
    this.composed = null;
    for (const child of this.children) child.forget();
  }
}

class Tree {
  constructor() {
    this.root = new SceneNode(0, null, "group");
    this.nodes = new Map([[0, this.root]]);
    this.list = null;
  }

  get(id) {
    return this.nodes.get(id);
  }

  add(id, parent, kind) {
    const node = new SceneNode(id, this.nodes.get(parent) ?? this.root, kind);
    this.nodes.set(id, node);
    this.list = null;
    return node;
  }

  show(node, visible) {
    if (node.visible === visible) return;
    node.visible = visible;
    this.list = null;
  }

  /** Removes a node with its children and returns them. */
  drop(id) {
    const top = this.nodes.get(id);
    if (!top || top === this.root) return [];
    top.parent.children.delete(top);
    const removed = [top];
    for (let k = 0; k < removed.length; k++) {
      for (const child of removed[k].children) removed.push(child);
      this.nodes.delete(removed[k].id);
    }
    this.list = null;
    return removed;
  }

  /** Visible nodes, parents first, in order of addition. */
  visibleNodes() {
    if (this.list === null) {
      this.list = [];
      const visit = (node) => {
        if (!node.visible) return;
        if (node.geometry || node.label) this.list.push(node);
        for (const child of node.children) visit(child);
      };
      visit(this.root);
    }
    return this.list;
  }
}
