/** Starts the page after all parts are loaded. */
// A notebook cell opens its frame at this message (src/pointloom/visualization/notebook_output.py).
if (parent !== window) parent.postMessage("pointloom", "*");
const live = new Live();
live.start();
// for embedding pages and tests
window.pointloom = { ready: () => live.ready() };
