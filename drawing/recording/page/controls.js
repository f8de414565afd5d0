/** Mouse, pen, fingers and wheel move the camera. */
const TURN = 0.006; // radians a pixel
const ZOOM = 0.0015; // of the logarithm of the distance, a pixel of the wheel

class Controls {
  /** `changed` is called after each move; `pick` gives the place of the world at a pixel, or null. */
  constructor(element, camera, { changed, pick }) {
    Object.assign(this, { element, camera, changed, pick });
    this.pointers = new Map();
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel"]) element.addEventListener(kind, (event) => this.pointers.delete(event.pointerId));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("dblclick", (event) => this.doubleClick(event));
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  place(event) {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event) {
    this.element.focus();
    this.element.setPointerCapture(event.pointerId);
    const pans = event.button === 2 || event.button === 1 || event.shiftKey;
    this.pointers.set(event.pointerId, { place: this.place(event), pans });
  }

  move(event) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const before = pointer.place;
    pointer.place = this.place(event);
    const [dx, dy] = [pointer.place[0] - before[0], pointer.place[1] - before[1]];
    if (this.pointers.size === 2) this.pinch(pointer, before);
    else if (pointer.pans) this.camera.pan(dx, dy);
    else this.camera.orbit(dx * TURN, dy * TURN);
    this.changed();
  }

  /** Two fingers: their middle moves the picture, their distance scales it. */
  pinch(pointer, before) {
    const [other] = [...this.pointers.values()].filter((one) => one !== pointer).map((one) => one.place);
    const apart = (place) => Math.max(Math.hypot(place[0] - other[0], place[1] - other[1]), 1);
    const middle = [(pointer.place[0] + other[0]) / 2, (pointer.place[1] + other[1]) / 2];
    this.camera.pan((pointer.place[0] - before[0]) / 2, (pointer.place[1] - before[1]) / 2);
    this.camera.zoom(apart(before) / apart(pointer.place), ...middle);
  }

  wheel(event) {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    this.camera.zoom(Math.exp(clamp(pixels, -400, 400) * ZOOM), ...this.place(event));
    this.changed();
  }

  doubleClick(event) {
    const place = this.pick(...this.place(event));
    if (place) this.camera.lookAt(place);
    this.changed();
  }
}
