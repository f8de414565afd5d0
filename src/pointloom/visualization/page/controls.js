/** Mouse, pen, touch and wheel control of the camera; a press without motion is a click. */
const TURN = 0.006; // [rad] per pixel
const ZOOM = 0.0015; // of the logarithm of the distance, per pixel of the wheel
const STILL = { mouse: 3, pen: 6, touch: 9 }; // [CSS px] within which a press is no drag

class Controls {
  /** `move(name, ...values)` moves the active view, `use(x, y)` activates one; `click` and `doubleClick` are callbacks. */
  constructor(element, { move, use, click, doubleClick }) {
    Object.assign(this, { element, moveView: move, use, click, doubleClick });
    element.style.touchAction = "none"; // touch moves the camera, not the page
    this.pointers = new Map();
    const listen = (kind, run) => element.addEventListener(kind, run, { passive: false });
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event));
    listen("pointercancel", (event) => this.pointers.delete(event.pointerId));
    listen("wheel", (event) => this.wheel(event));
    listen("dblclick", (event) => this.doubleClick(...this.place(event)));
    listen("contextmenu", (event) => event.preventDefault());
  }

  place(event) {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event) {
    this.element.focus({ preventScroll: true });
    try {
      this.element.setPointerCapture(event.pointerId);
    } catch {
      // synthetic or ended pointers cannot be captured: they still move the camera
    }
    const place = this.place(event);
    if (this.pointers.size === 0) this.use(...place);
    const pans = event.button === 2 || event.button === 1 || event.shiftKey;
    this.pointers.set(event.pointerId, { place, start: place, pans, drags: false });
    if (this.pointers.size > 1) for (const pointer of this.pointers.values()) pointer.drags = true;
  }

  move(event) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const place = this.place(event);
    const moved = Math.hypot(place[0] - pointer.start[0], place[1] - pointer.start[1]);
    if (!pointer.drags && moved <= (STILL[event.pointerType] ?? STILL.mouse)) return;
    pointer.drags = true;
    const before = pointer.place;
    pointer.place = place;
    const [dx, dy] = [place[0] - before[0], place[1] - before[1]];
    if (this.pointers.size === 2) this.pinch(pointer, before);
    else if (pointer.pans) this.moveView("pan", dx, dy);
    else this.moveView("orbit", dx * TURN, dy * TURN);
  }

  up(event) {
    const pointer = this.pointers.get(event.pointerId);
    this.pointers.delete(event.pointerId);
    if (pointer && !pointer.drags && event.button === 0) this.click(...pointer.start);
  }

  /** Two fingers: their center translates, their distance zooms. */
  pinch(pointer, before) {
    const [other] = [...this.pointers.values()].filter((one) => one !== pointer).map((one) => one.place);
    const apart = (place) => Math.max(Math.hypot(place[0] - other[0], place[1] - other[1]), 1);
    const middle = [(pointer.place[0] + other[0]) / 2, (pointer.place[1] + other[1]) / 2];
    this.moveView("pan", (pointer.place[0] - before[0]) / 2, (pointer.place[1] - before[1]) / 2);
    this.moveView("zoom", apart(before) / apart(pointer.place), ...middle);
  }

  wheel(event) {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    const place = this.place(event);
    this.use(...place);
    this.moveView("zoom", Math.exp(clamp(pixels, -400, 400) * ZOOM), ...place);
  }
}
