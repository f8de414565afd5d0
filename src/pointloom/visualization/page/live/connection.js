/**
 * Connection to the program: reopened with growing pauses, and at once if the page becomes visible or the network
 * returns. `stateChanged` is called with "connecting", "open", "lost", "ended", "old".
 */
const PAUSES = [500, 1000, 2000, 3500, 5000]; // [ms] before an attempt; the last one repeats
const GIVEN_UP = 20_000; // [ms] without an answer after which the program is assumed to have ended
const MAX_BYTES = 60 * 1024; // of one message, except for files; the program accepts 64 KiB
const MAX_FILE = 1024 * 1024;
const BUSY = 256 * 1024; // unsent bytes above which the camera is not sent
const OTHER_VERSION = 4001; // close code for a page of another version

class Connection {
  /** `received` is called with each message; `hello` returns the first message. */
  constructor({ received, stateChanged, hello }) {
    Object.assign(this, { received, stateChanged, hello });
    this.state = "connecting";
    this.tries = 0;
    this.timer = null;
    this.socket = null;
    this.wasOpen = false;
    this.lostAt = performance.now();
    this.ending = null;
    this.syncs = new Map(); // by number: callbacks for answers
    this.syncCount = 0;
    document.addEventListener("visibilitychange", () => this.onSight());
    window.addEventListener("online", () => this.onNetwork());
    window.addEventListener("pageshow", () => this.onSight());
    window.addEventListener("pagehide", () => this.socket?.close());
  }

  get isOpen() {
    return this.state === "open";
  }

  open() {
    clearTimeout(this.timer);
    this.timer = null;
    const token = new URLSearchParams(location.search).get("token") ?? "";
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const folder = location.pathname.replace(/[^/]*$/, "");
    const socket = new WebSocket(`${scheme}://${location.host}${folder}live?token=${encodeURIComponent(token)}`, PROTOCOL);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.onOpen(socket);
    socket.onmessage = (event) => this.onMessage(socket, event);
    socket.onclose = (event) => this.onClose(socket, event);
    this.socket = socket;
  }

  onOpen(socket) {
    if (socket !== this.socket) return;
    if (socket.protocol !== PROTOCOL) return this.refuse();
    const again = this.wasOpen;
    Object.assign(this, { tries: 0, wasOpen: true, ending: null });
    this.setState("open", { again });
    this.send(this.hello());
    for (const n of this.syncs.keys()) this.send({ say: "sync", n });
  }

  onMessage(socket, event) {
    if (socket !== this.socket || typeof event.data === "string") return;
    this.received(event.data);
  }

  onClose(socket, event) {
    if (socket !== this.socket) return;
    this.socket = null;
    if (event.code === OTHER_VERSION) return this.refuse();
    if (this.state === "open") this.lostAt = performance.now();
    if (this.ending !== null || performance.now() - this.lostAt > GIVEN_UP) this.setState("ended", { text: this.ending ?? "" });
    else this.setState(this.wasOpen ? "lost" : "connecting");
    this.retry();
  }

  /** The program has another version than this cached page: only reloading helps. */
  refuse() {
    const socket = this.socket;
    this.socket = null;
    socket?.close();
    this.setState("old");
  }

  retry() {
    if (this.state === "old" || document.hidden) return;
    const pause = PAUSES[Math.min(this.tries, PAUSES.length - 1)];
    this.tries += 1;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.open(), pause);
  }

  hurry() {
    if (this.state === "old") return;
    this.tries = 0;
    if (this.socket === null) this.open();
  }

  onSight() {
    if (document.hidden) return;
    if (this.socket?.readyState === WebSocket.OPEN) return this.send({ say: "resume" });
    if (this.socket?.readyState !== WebSocket.CONNECTING) this.socket = null; // closed while the page was suspended
    this.hurry();
  }

  /** Resets the state for a new connection. */
  startAgain() {
    this.onNetwork();
  }

  /** A connection from before a network change is unusable, whatever its state. */
  onNetwork() {
    const socket = this.socket;
    if (socket && this.isOpen) {
      this.onClose(socket, {});
      socket.close();
    }
    this.hurry();
  }

  /** The program reported its end. */
  end(text) {
    this.ending = text;
    this.setState("ended", { text });
  }

  setState(state, more = {}) {
    const before = this.state;
    this.state = state;
    this.stateChanged(state, { before, ...more });
  }

  /** Sends a message if connected. True if sent. */
  send(message, maxLength = MAX_BYTES) {
    if (!this.socket || this.socket.readyState !== WebSocket.OPEN) return false;
    const text = JSON.stringify(message);
    if (text.length > maxLength || (text.length > maxLength / 3 && new Blob([text]).size > maxLength)) return false;
    this.socket.send(text);
    return true;
  }

  /** Resolves when the program has handled all messages, and its answers have been applied. */
  sync() {
    const n = (this.syncCount += 1);
    return new Promise((resolve) => {
      this.syncs.set(n, resolve);
      this.send({ say: "sync", n }); // without a connection it is sent after opening
    });
  }

  onSync(n) {
    this.syncs.get(n)?.();
    this.syncs.delete(n);
  }

  get isBusy() {
    return (this.socket?.bufferedAmount ?? 0) > BUSY;
  }
}
