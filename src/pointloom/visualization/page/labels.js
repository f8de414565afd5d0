/** Text labels on their own canvas over the scene: drawn, never parsed as HTML. */
const LABEL_FONT = "500 12px system-ui, sans-serif";
const LABEL_ROOM = [5, 3]; // [CSS px] padding
const LABEL_HEIGHT = 15;
const SHARES = { "bottom-left": [0, 1], "bottom-center": [0.5, 1], center: [0.5, 0.5] };
const LABEL_COLORS = {
  light: { ink: "#1c2430", sheet: "rgba(255, 255, 255, 0.86)", edge: "rgba(0, 0, 0, 0.22)" },
  dark: { ink: "#e8ecf1", sheet: "rgba(24, 28, 34, 0.86)", edge: "rgba(255, 255, 255, 0.28)" },
};

class Labels {
  constructor(overlay) {
    this.canvas = document.createElement("canvas");
    this.canvas.className = "labels";
    overlay.append(this.canvas);
    this.context = this.canvas.getContext("2d");
    this.count = 0;
  }

  resize(width, height, density) {
    Object.assign(this, { width, height, density });
    Object.assign(this.canvas, { width: Math.max(1, Math.round(width * density)), height: Math.max(1, Math.round(height * density)) });
    this.count = -1;
  }

  /** Draws the labels of each view; nearer ones cover farther ones. */
  draw(nodes, views, dark) {
    const labels = nodes.filter((node) => node.label);
    if (labels.length === 0 && this.count === 0) return;
    this.count = labels.length;
    const { context } = this;
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    Object.assign(context, { font: LABEL_FONT, textBaseline: "middle" });
    for (const camera of views.cameras) {
      const { box } = camera;
      context.save();
      context.beginPath();
      context.rect(box.x, box.y, box.width, box.height);
      context.clip();
      const projected = labels.map((node) => ({ node, at: camera.project([node.world[3], node.world[7], node.world[11]]) }));
      const before = projected.filter(({ at }) => camera.orthographic || at[2] > 0);
      for (const { node, at } of before.sort((a, b) => b.at[2] - a.at[2])) this.write(node, at, LABEL_COLORS[dark ? "dark" : "light"]);
      context.restore();
    }
  }

  write({ label, props }, [x, y], { ink, sheet, edge }) {
    const { context } = this;
    if (x < -1e4 || x > 2e4 || y < -1e4 || y > 2e4) return;
    label.lines ??= String(props.text ?? "").split("\n", 20).map((line) => line.slice(0, 400));
    label.width ??= Math.max(...label.lines.map((line) => context.measureText(line).width));
    const [width, height] = [label.width + 2 * LABEL_ROOM[0], LABEL_HEIGHT * label.lines.length + 2 * LABEL_ROOM[1]];
    const [across, down] = SHARES[props.anchor] ?? SHARES.center;
    const [left, top] = [Math.round(x - across * width), Math.round(y - down * height - (down === 1 ? 4 : 0))];
    Object.assign(context, { fillStyle: sheet, strokeStyle: edge, lineWidth: 1 });
    context.beginPath();
    context.roundRect(left + 0.5, top + 0.5, Math.round(width), Math.round(height), 4);
    context.fill();
    context.stroke();
    context.fillStyle = ink;
    const [start, first] = [left + LABEL_ROOM[0] + 0.5, top + LABEL_ROOM[1] + LABEL_HEIGHT / 2 + 1];
    label.lines.forEach((line, k) => context.fillText(line, start, first + LABEL_HEIGHT * k));
  }
}
