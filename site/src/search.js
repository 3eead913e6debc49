// Which parts of the site have all words of a query, best first. `hgpSearch.parts` is filled by search-index.js, which
// the build puts together of this file and the list of all parts.

globalThis.hgpSearch = {
  /** { file, title, heading, id, text } of each part */
  parts: [],

  /** @param {number} most  how many are returned */
  rank(query, most) {
    const fold = (text) => text.toLowerCase().normalize('NFKD').replace(/\p{M}/gu, '');
    const words = fold(query)
      .split(/[^\p{L}\p{N}_]+/u)
      .filter(Boolean);
    if (words.length === 0) return [];
    const starts = (text, word) => {
      let count = 0;
      for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
        if (at === 0 || !/[\p{L}\p{N}]/u.test(text[at - 1])) count++;
      return count;
    };
    const scored = [];
    for (const part of this.parts) {
      part.folded ??= [part.title, part.heading, part.text].map(fold);
      const [title, heading, text] = part.folded;
      let score = 0;
      for (const word of words) {
        const points =
          12 * Math.min(1, starts(heading, word)) +
          6 * Math.min(1, starts(title, word)) +
          Math.min(4, starts(text, word)) +
          (heading.split(/[^\p{L}\p{N}_]+/u).includes(word) ? 8 : 0);
        if (points === 0) {
          score = 0;
          break;
        }
        score += points;
      }
      // Of the same words, explanations before symbols, and short parts before long ones.
      if (score > 0)
        scored.push([
          score + (part.file.startsWith('api/') ? 0 : 3) + 20 / (20 + text.length),
          part,
        ]);
    }
    scored.sort(([a], [b]) => b - a);
    return scored.slice(0, most).map(([, part]) => {
      const at = Math.max(0, part.folded[2].indexOf(words[0]) - 40);
      return { ...part, extract: (at > 0 ? '… ' : '') + part.text.slice(at, at + 140) };
    });
  },
};
