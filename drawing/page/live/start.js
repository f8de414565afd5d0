/** Begins, once all parts are there. */
// The cell of a notebook opens its frame when the page in it says that it is there (drawing/notebook_output.py).
if (parent !== window) parent.postMessage("pointloom", "*");
const live = new Live();
live.start();
// for whoever embeds the page, and for its tests
window.pointloom = { ready: () => live.ready() };
