// From disk nothing can be fetched: search shows titles alone there, without an error for each result.
if (location.protocol === "file:" && typeof DOCUMENTATION_OPTIONS !== "undefined") {
  DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
}

// Names break after a point or an underscore, not inside a word.
document.addEventListener("DOMContentLoaded", () => {
  for (const title of document.querySelectorAll("h1, .bd-sidebar-secondary code")) {
    for (const node of [...title.childNodes].filter((child) => child.nodeType === Node.TEXT_NODE && /[._]/.test(child.data))) {
      node.replaceWith(...node.data.split(/(?<=[._])/).flatMap((part) => [part, document.createElement("wbr")]).slice(0, -1));
    }
  }
});
