// The pages of the site, in the order in which they are read. A page is web/pages/KEY.md, and is
// served from the folder of that name; the first is the site's own.

/** @typedef {{ key: string, folder: string, title: string, about: string, group?: string }} Page */

/** @type {readonly Page[]} */
export const kPages = [
  {
    key: "home",
    folder: "",
    title: "Apollonius diagram",
    about:
      "The nearest circle, not the nearest centre: " +
      "exact Voronoi diagrams of circles for JavaScript.",
  },
  {
    key: "why",
    folder: "why",
    title: "Why circles",
    about: "What changes when distance is measured to rims and not to centres.",
    group: "Explained",
  },
  {
    key: "hidden",
    folder: "hidden",
    title: "Hidden circles",
    about: "A circle inside another one is nowhere the nearest, until the other one moves away.",
    group: "Explained",
  },
  {
    key: "asking",
    folder: "asking",
    title: "Asking",
    about: "Nearest circle, circle under the pointer, circles within a distance, the five nearest.",
    group: "Explained",
  },
  {
    key: "insertion",
    folder: "insertion",
    title: "Insertion",
    about: "What changes in a diagram when one circle comes: a walk, a hole, a star.",
    group: "Explained",
  },
  {
    key: "deletion",
    folder: "deletion",
    title: "Deletion",
    about: "How a hole is closed when a circle goes, and why each way back is the same.",
    group: "Explained",
  },
  {
    key: "exactness",
    folder: "exactness",
    title: "Exactness",
    about: "What rounding does to a diagram, and what it costs to be right.",
    group: "Explained",
  },
  {
    key: "areas",
    folder: "areas",
    title: "Areas",
    about: "Cells with the areas you ask for: capacities, territories, treemaps.",
    group: "Explained",
  },
  {
    key: "regions",
    folder: "regions",
    title: "Regions and the globe",
    about: "Cells that end at a coast, and cells on a sphere.",
    group: "Explained",
  },
  {
    key: "scale",
    folder: "scale",
    title: "Scale",
    about: "From a hundred circles to a million, measured in your browser.",
    group: "Explained",
  },
  {
    key: "recipes",
    folder: "recipes",
    title: "Recipes",
    about: "Programs for common tasks, to change and to run in the page.",
  },
  {
    key: "comparison",
    folder: "comparison",
    title: "Comparison",
    about: "What other libraries do better, and when to take them instead.",
    group: "Reference",
  },
  {
    key: "asked",
    folder: "asked",
    title: "Asked for",
    about: "What people ask for in public threads, and the call that answers it.",
    group: "Reference",
  },
];
