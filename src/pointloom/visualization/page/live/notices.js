/** Texts over the image: notices, progress, lost connection, ended program. */
const MAX_NOTICES = 4;
const SLOW_LINE = 700; // [ms] without an answer before the page reports it

class Notices {
  constructor({ list, progress, state, hint, tryNow }) {
    Object.assign(this, { list, progress, state, hint });
    this.text = make("span", { class: "text" });
    this.share = make("div", { class: "share" });
    progress.append(make("div", { class: "words" }, make("span", { class: "spinner", "aria-hidden": "true" }), this.text), make("div", { class: "meter" }, this.share));
    this.stateTitle = make("strong");
    this.stateText = make("p");
    this.stateButton = make("button", { type: "button" });
    this.stateSpinner = make("span", { class: "spinner", "aria-hidden": "true" });
    state.append(make("div", { class: "words" }, this.stateSpinner, this.stateTitle), this.stateText, this.stateButton);
    this.stateButton.addEventListener("click", () => (this.isOld ? location.reload() : tryNow()));
  }

  /** A notice; it stays while hovered or focused. */
  notify(title, text = "", seconds = 8, kind = "note") {
    const close = iconButton("close", "Close", () => remove());
    const content = make("div", {}, make("strong", {}, title), text ? make("p", {}, text) : null);
    const notice = make("div", { class: `notice ${kind === "error" ? "error" : "note"}`, role: kind === "error" ? "alert" : "status" }, content, close);
    const remove = () => {
      clearTimeout(timer);
      notice.remove();
    };
    const wait = () => setTimeout(() => (notice.matches(":hover, :focus-within") ? (timer = wait()) : remove()), 1000 * clamp(seconds, 1, 3600));
    let timer = wait();
    this.list.append(notice);
    while (this.list.children.length > MAX_NOTICES) this.list.firstChild.remove();
  }

  setProgress(text, share = null) {
    this.progress.hidden = text === "";
    const percent = share === null ? null : Math.round(100 * clamp(share, 0, 1));
    this.text.textContent = percent === null || /%\s*$/.test(text) ? text : `${text} ${percent} %`;
    this.progress.classList.toggle("unknown", percent === null);
    this.share.style.width = `${percent ?? 30}%`;
    if (percent === null) this.progress.removeAttribute("aria-valuenow");
    else this.progress.setAttribute("aria-valuenow", percent);
    this.progress.setAttribute("aria-valuetext", this.text.textContent);
  }

  setHint(text) {
    this.hint.textContent = text;
    this.hint.hidden = text === "";
  }

  /** Connection state; shown only if not open. */
  setState(name, { text = "", hadScene = true } = {}) {
    if (this.shownState === name + text) return; // shown already
    this.shownState = name + text;
    clearTimeout(this.waiting);
    this.isOld = name === "old";
    if (name === "open") {
      this.state.hidden = true;
      return;
    }
    const [title, words, button] = {
      connecting: ["Connecting …", "", ""],
      lost: ["Connection lost; trying again", hadScene ? "The displayed scene is unchanged." : "", "Try now"],
      ended: ["The program has ended.", text || RESTART, "Try again"],
      old: ["Reload the page", "The program and this page have different versions.", "Reload"],
    }[name];
    const show = () => {
      this.stateTitle.textContent = title;
      this.stateText.textContent = words;
      this.stateText.hidden = words === "";
      this.stateButton.textContent = button;
      this.stateButton.hidden = button === "";
      this.stateSpinner.hidden = name === "ended" || name === "old";
      this.state.dataset.state = name;
      this.state.hidden = false;
    };
    if (name === "connecting" && this.state.hidden) this.waiting = setTimeout(show, SLOW_LINE);
    else show();
  }
}

const RESTART = "Start it again, and open the address that it prints. The displayed scene is unchanged.";
