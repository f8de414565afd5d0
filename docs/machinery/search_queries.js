// Search a built site as its search page does, and check the first results of the queries in search_queries.txt.
//
//     node docs/machinery/search_queries.js build/docs/html [--show]
//
// Exits with 1 if no expected page is among the first SHOWN results of a query, or a decision record is.

const fs = require("fs");
const path = require("path");
const vm = require("vm");

const SHOWN = 5;
const [site, show] = process.argv.slice(2);
const context = vm.createContext({
  document: { getElementById: () => null, addEventListener: () => {}, querySelectorAll: () => [], readyState: "complete" },
  location: { search: "" },
  URLSearchParams,
  localStorage: { setItem: () => {} },
  SPHINX_HIGHLIGHT_ENABLED: false,
  DOCUMENTATION_OPTIONS: {},
  _: (text) => text,
  _ready: () => {},
});
context.window = context;
for (const file of ["_static/searchtools.js", "_static/language_data.js", "searchindex.js"]) {
  vm.runInContext(fs.readFileSync(path.join(site, file), "utf8"), context, { filename: file });
}
const search = vm.runInContext("(query) => Search._performSearch(...Search._parseQuery(query)).reverse()", context);

let failed = 0;
const lines = fs.readFileSync(path.join(__dirname, "search_queries.txt"), "utf8").split("\n");
for (const line of lines.filter((line) => line.includes("|"))) {
  const [query, expected] = line.split("|").map((part) => part.trim());
  const results = search(query).map(([page, , anchor]) => page + anchor);
  const first = results.slice(0, SHOWN);
  const isFound = first.some((result) => expected.split(" ").some((page) => result === page || result.startsWith(`${page}#`)));
  const isRight = isFound && !first.some((result) => result.startsWith("adr/"));
  failed += !isRight;
  if (show || !isRight) {
    const rank = results.findIndex((result) => expected.split(" ").some((page) => result === page || result.startsWith(`${page}#`)));
    console.log(`${isRight ? "ok  " : "FAIL"} ${query} | rank ${rank + 1 || "none"} | ${results.slice(0, 6).join(", ")}`);
  }
}
console.log(`search: ${lines.filter((line) => line.includes("|")).length} queries, ${failed} without an expected page in the first ${SHOWN} results`);
process.exitCode = failed ? 1 : 0;
