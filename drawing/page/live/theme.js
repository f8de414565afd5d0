/**
 * Light or dark: as the system says, until somebody switches. The picture's ground follows, where the program left it
 * open; words that lie on the picture follow its ground.
 */
const DARK_GROUND = [0.075, 0.086, 0.106];
const THEMES = ["auto", "light", "dark"];

class Theme {
  /** `ground(rgb)` is called for the picture. */
  constructor(ground) {
    this.ground = ground;
    this.choice = THEMES.includes(memory.get("theme")) ? memory.get("theme") : "auto";
    this.color = [1, 1, 1];
    this.own = false;
    this.system = matchMedia("(prefers-color-scheme: dark)");
    this.system.addEventListener("change", () => this.apply());
  }

  get isDark() {
    return this.choice === "auto" ? this.system.matches : this.choice === "dark";
  }

  /** To what it is not now; where that is the system's own way, back to following the system. */
  toggle() {
    const wanted = this.isDark ? "light" : "dark";
    this.choice = (wanted === "dark") === this.system.matches ? "auto" : wanted;
    memory.set("theme", this.choice);
    this.apply();
  }

  setGround(color, own) {
    Object.assign(this, { color, own });
    this.apply();
  }

  apply() {
    const root = document.documentElement;
    root.dataset.theme = this.isDark ? "dark" : "light";
    const ground = !this.own && this.isDark ? DARK_GROUND : this.color;
    const light = 0.299 * ground[0] + 0.587 * ground[1] + 0.114 * ground[2];
    root.dataset.ground = light < 0.5 ? "dark" : "light";
    root.style.setProperty("--ground", cssColor(ground.map((part) => 255 * clamp(part, 0, 1))));
    this.ground(ground);
  }
}
