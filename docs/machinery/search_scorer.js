// Ranks the results of Sphinx's search: names and guides first, decision records last, pages without some of the words
// after those with all. Sphinx puts this file into _static/language_data.js, after searchtools.js.

// Weights of pages by the beginning of their names, the longest counts.
// Chosen on the queries marked "tuned" in search_queries.txt.
const PAGE_WEIGHTS = {
  "": 1.3, // guides
  "chapters/": 1.1,
  "gallery/": 0.9,
  "commands/": 1.1,
  "reference/": 1.3,
  "reference/pointloom.torch": 0.9,
  "reference/coverage": 0.1,
  "project/": 0.5,
  "project/changelog": 0.2,
  "adr/": 0.15,
  "open3d-names": 0.5,
  "measured": 0.7,
};
const OTHER_RESULT = 0.6; // the text of a page counts for its names, too
const GUIDE_TITLE = 2; // a guide about the topic comes before single names
const SECTION = 0.4; // titles of sections
const SHOWN_RESULTS = 60; // the page fetches a summary of each
const DEPTH = 0.15; // lower weight of names for each point in them
const OPTION = 0.3; // options of commands: their names are common words

Object.assign(Scorer, {
  objNameMatch: 14,
  objPartialMatch: 8,
  objPrio: { 0: 3, 1: 3, 2: 0 },
  title: 18,
  partialTitle: 9,
  term: 3,
  partialTerm: 1,
});

function pageWeight(page) {
  const prefixes = Object.keys(PAGE_WEIGHTS).filter((prefix) => page.startsWith(prefix));
  return PAGE_WEIGHTS[prefixes.reduce((best, prefix) => (prefix.length > best.length ? prefix : best), "")];
}

// Words of readers and the parts of names with the same meaning.
const NAMES = { downsample: "down_sample", downsampling: "down_sample", subsample: "down_sample", save: "write", load: "read" };

// Score of a result for one word, or its stem. A complete part of a name counts more than letters within another word.
function wordScore([page, name, anchor, , score, , kind], word) {
  if (kind === SearchResultKind.index) return 0; // repeats names and options
  if (kind !== SearchResultKind.object) {
    if (anchor && page.startsWith("reference/")) return SECTION * score;
    if (score < Scorer.partialTitle) return score;
    const title = name.split(" > ")[0].toLowerCase();
    return score * (!title.includes(word) ? SECTION : page.includes("/") ? 1 : GUIDE_TITLE);
  }
  if (anchor.startsWith("#cmdoption-")) return OPTION * score;
  const parts = name.split(".").pop().split(/_|(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])/).map((part) => part.toLowerCase());
  const last = parts.join("_");
  if (!last.includes(word)) return score / 2; // a word of the class
  const depth = name.split(".").length; // 2 for loom.render, 4 for methods of classes in modules
  return (1.5 - DEPTH * depth) * ((last === word || parts.includes(word) ? 1.5 : 1) * score + (4 * word.length) / last.length);
}

const searchAllWords = Search._performSearch;

Search._performSearch = (query, terms, excluded, highlighted, objectTerms) => {
  const words = [...objectTerms].filter((word) => !stopwords.has(word));
  const found = new Map(); // page and anchor to the result and its score for each word
  const pageScores = words.map(() => new Map());
  words.forEach((word, k) => {
    const [parsed, stems, , , names] = Search._parseQuery(word);
    const stem = NAMES[word] ?? [...stems][0] ?? word;
    const results = searchAllWords(parsed, stems, excluded, highlighted, names);
    if (stem !== word) results.push(...Search.performObjectSearch(stem, new Set([stem])));
    const rarity = 1 / Math.log2(4 + results.length);
    for (const result of results) {
      const key = result[0] + result[2];
      const score = rarity * Math.max(...[word, stem].map((part) => wordScore(result, part)));
      if (!score) continue;
      const scores = found.get(key)?.scores ?? words.map(() => 0);
      const best = found.get(key)?.result;
      if (!best || score > Math.max(...scores)) found.set(key, { result, scores });
      scores[k] = Math.max(scores[k], score);
      if (!result[2]) pageScores[k].set(result[0], Math.max(pageScores[k].get(result[0]) ?? 0, score));
    }
  });
  Search._parseQuery(query); // stores the words to highlight
  const results = [];
  for (const { result, scores } of found.values()) {
    const complete = scores.map((score, k) => Math.max(score, OTHER_RESULT * (pageScores[k].get(result[0]) ?? 0)));
    const share = complete.filter((score) => score > 0).length / words.length;
    const total = complete.reduce((sum, score) => sum + score, 0) * share ** 2 * pageWeight(result[0]);
    results.push([...result.slice(0, 4), total, ...result.slice(5)]);
  }
  return results.sort(_orderResultsByScoreThenName).slice(-SHOWN_RESULTS); // the best result is the last
};
