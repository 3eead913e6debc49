// The pages of the site that are made of Markdown, in the order of its navigation. Whatever they link to and is not
// listed here is either copied (pictures, schemas) or named without a link.

export const sections = [
  {
    title: 'Use it',
    pages: [
      ['docs/guide.md', 'guide.html', 'Guide'],
      ['docs/not-certified.md', 'not-certified.html', 'Not certified: what now'],
      ['docs/which-tool.md', 'which-tool.html', 'Which tool'],
      ['docs/cli.md', 'cli.html', 'Command-line reference'],
      ['docs/batch.md', 'batch.html', 'Many meshes'],
    ],
  },
  {
    title: 'Five minutes with',
    pages: [
      ['docs/five-minutes/command-line.md', 'five-minutes/command-line.html', 'the command line'],
      ['docs/five-minutes/cpp.md', 'five-minutes/cpp.html', 'C++'],
      ['docs/five-minutes/javascript.md', 'five-minutes/javascript.html', 'JavaScript'],
      ['docs/five-minutes/three.md', 'five-minutes/three.html', 'three.js'],
      ['docs/five-minutes/python.md', 'five-minutes/python.html', 'Python'],
      ['docs/five-minutes/blender.md', 'five-minutes/blender.html', 'Blender'],
    ],
  },
  {
    title: 'Reference',
    pages: [
      ['python/README.md', 'python.html', 'Python package'],
      ['wasm/package/README.md', 'npm.html', 'npm package'],
    ],
  },
  {
    title: 'How it works',
    pages: [
      ['docs/architecture.md', 'architecture.html', 'Architecture'],
      ['docs/notation.md', 'notation.html', 'Notation'],
      ['docs/paper-map.md', 'paper-map.html', 'Equations and their code'],
      ['docs/errata.md', 'errata.html', 'Errata of the paper'],
      ['docs/works-cited.md', 'works-cited.html', 'Works cited'],
      ['CHANGELOG.md', 'changelog.html', 'Changelog'],
    ],
  },
];

/** The references made of sources: title, first page. */
export const references = [
  ['api/cpp/index.html', 'C++ API'],
  ['api/js/index.html', 'JavaScript API'],
  ['api/python/index.html', 'Python API'],
];

export const markdownPages = sections.flatMap((section) =>
  section.pages.map(([source, file, title]) => ({ source, file, title, section: section.title })),
);
