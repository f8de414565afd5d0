/** What lies in the corners of each view: the axes, and how long things are. The view in use has a frame where it is one of several. */
class Corners {
  /** `look(axis, view)` looks along "+x" ... "-z" in a view. */
  constructor(overlay, { gizmo, scaleBar, look }) {
    Object.assign(this, { overlay, gizmo, scaleBar, look, unit: null, views: [] });
  }

  make(view) {
    const element = document.createElement("div");
    element.className = "view";
    this.overlay.append(element);
    return {
      element,
      gizmo: this.gizmo ? new Gizmo(element, (axis) => this.look(axis, view)) : null,
      scaleBar: this.scaleBar ? new ScaleBar(element) : null,
    };
  }

  draw({ cameras, active }) {
    while (this.views.length < cameras.length) this.views.push(this.make(this.views.length));
    for (const { element } of this.views.splice(cameras.length)) element.remove();
    this.views.forEach(({ element, gizmo, scaleBar }, k) => {
      const { x, y, width, height } = cameras[k].box;
      Object.assign(element.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
      element.classList.toggle("active", cameras.length > 1 && k === active);
      gizmo?.draw(cameras[k]);
      scaleBar?.draw(cameras[k], this.unit);
    });
  }

  /** The scale bars in a picture of the canvas. */
  paint(context, canvas, density) {
    for (const { scaleBar } of this.views) scaleBar?.paint(context, canvas, density);
  }
}
