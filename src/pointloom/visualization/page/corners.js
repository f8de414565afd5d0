/** Content of the corners of each view: axes and scale bar. The active one of several views has a frame. */
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

  paint(context, canvas, density) {
    for (const { scaleBar } of this.views) scaleBar?.paint(context, canvas, density);
  }
}
