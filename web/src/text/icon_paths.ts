// Icons: paths on a grid of 16 × 16, drawn in the colour of the text.

export const iconPaths = {
  open: 'M2 13V3h4l1.5 2H14v8zM2 7h12',
  undo: 'M6 3 2.5 6.5 6 10M3 6.5h6.5a4 4 0 0 1 0 8H6',
  redo: 'M10 3l3.5 3.5L10 10M13 6.5H6.5a4 4 0 0 0 0 8H10',
  run: 'M4.5 2.5v11l9-5.5z',
  download: 'M8 2v8M4.5 7 8 10.5 11.5 7M2.5 13.5h11',
  help: 'M5.8 6a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6M8 12.2v.1M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13',
  theme: 'M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12',
  orbit: 'M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M1.5 9.5C3 13 13 13 14.5 9.5M1.5 6.5C3 3 13 3 14.5 6.5',
  place: 'M8 2v12M2 8h12M8 5.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5',
  frame: 'M2 5V2h3M11 2h3v3M14 11v3h-3M5 14H2v-3',
  edges: 'M2 11 8 14 14 11V5L8 2 2 5zM2 5l6 3 6-3M8 8v6',
  wire: 'M2 13 8 2.5 14 13zM5 7.8h6M8 13 5 7.8M8 13l3-5.2',
  seams: 'M3 13c2-4 0-6 3-6s2 3 4 3 1-5 3-7',
  cross: 'M4 4l8 8M12 4l-8 8',
  warning: 'M8 2 14.500 13.500h-13zM8 6.500v3.500M8 11.800h.1',
  more: 'M3 6l5 5 5-5',
  check: 'M3 8.5 6.5 12 13 4.5',
  folder: 'M2 13V3h4l1.5 2H14v8z',
  list: 'M5 4h9M5 8h9M5 12h9M2 4h.1M2 8h.1M2 12h.1',
  balance: 'M8 2v12M3 4.500h10M3 4.500 1 9h4zM13 4.500 11 9h4zM5 14h6',
  wand: 'M3 13 10 6M11.500 1.500v3M10 3h3M13.500 7.500v2M12.500 8.500h2M6 2.500v2M5 3.500h2',
  tiles: 'M2 2h5v5H2zM9 2h5v5H9zM2 9h5v5H2zM9 9h5v5H9z',
  wipe: 'M2 3h12v10H2zM8 1v14M10.500 6h1.500M10.500 8h1.500M10.500 10h1.500',
  sun: 'M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1v2M8 13v2M1 8h2M13 8h2M3 3l1.400 1.400M11.600 11.600 13 13M13 3l-1.400 1.400M4.400 11.600 3 13',
  film: 'M2 3h12v10H2zM5 3v10M11 3v10M2 6.300h3M2 9.700h3M11 6.300h3M11 9.700h3',
  link: 'M6.500 9.500l3-3M7 4.500l1.500-1.500a2.800 2.800 0 0 1 4 4L11 8.500M5 7.500 3.500 9a2.800 2.800 0 0 0 4 4L9 11.500',
  mirror: 'M8 1.500v13M6 4 2 12h4zM10 4l4 8h-4z',
  image: 'M2 3h12v10H2zM2 11l3.5-3.5L9 11l2-2 3 3M10.5 6h.1',
} as const;

export type Icon = keyof typeof iconPaths;
