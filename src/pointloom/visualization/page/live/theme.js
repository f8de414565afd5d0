/**
 * Light or dark theme: that of the system, until switched. The image background follows if the program did not set one;
 * texts on the image follow its background.
 */
const DARK_GROUND = [0.075, 0.086, 0.106];
const THEMES = ["auto", "light", "dark"];

class Theme {
  /** `ground(rgb)` is called with the image background. */
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

  /** Switches the theme; if the result is the system's theme, follows the system again. */
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
