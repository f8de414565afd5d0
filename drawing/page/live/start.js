/** Begins, once all parts are there. */
const live = new Live();
live.start();
