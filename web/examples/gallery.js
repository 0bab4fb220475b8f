// Cards of all examples, or the one that the address names, with its code.

const kExamples = {
  comparison: [
    "Centres and circles",
    "Left, the plain Voronoi diagram of the centres (d3-delaunay); right, the diagram of the " +
      "circles. What the cross picks is red.",
  ],
  bubble_chart: [
    "Bubble chart",
    "The pointer picks the bubble whose rim is nearest, or the smallest one it is in.",
  ],
  force: [
    "d3-force",
    "400 circles move, the diagram moves with them (updateMany each tick) and knows who is next " +
      "to whom.",
  ],
  worker: [
    "In a worker",
    "The nearest circle of each pixel, asked for in one call off the main thread.",
  ],
  grow: [
    "Growing circles",
    "Circles grow until they meet, and stop at the distance of the slider " +
      "(voronoi with a distance).",
  ],
  empty_circles: [
    "Empty circles",
    "The largest circles that still fit into a packing, one after the other (largestEmptyCircle).",
  ],
  clearance_path: [
    "Widest path",
    "The path between discs whose narrowest passage is widest, along the curves of the edges.",
  ],
  facilities: [
    "Who is there first",
    "Facilities with start-up times, and how large their areas are. Stations in grey are " +
      "nowhere first.",
  ],
  capacities: [
    "Capacities",
    "A country divided among hospitals in its cities, to each as much land as it has beds " +
      "(fitAreas). The beds are invented; cities: GeoNames, CC BY; outline: Natural Earth.",
  ],
  treemap: [
    "Voronoi treemap",
    "The world's economies by region and country, curved cells in curved cells: each has exactly " +
      "its share of the area. Data: Gapminder, CC BY.",
  ],
  nested: [
    "Treemap of four levels",
    "The classes of a program, packages within packages: the pointer makes a class grow, and all " +
      "others stay where they are. Data: Flare, BSD.",
  ],
  cities: [
    "As far as the coast",
    "What is nearest to each of the 1500 largest cities, on the world's land. Data: GeoNames, " +
      "CC BY; Natural Earth.",
  ],
  globe: [
    "Globe",
    "Turn it: which of 1500 cities is nearest to each place on Earth, in true kilometres " +
      "(SphericalDiagram). Data: GeoNames, CC BY; Natural Earth.",
  ],
  temperature: [
    "Temperature map",
    "40 stations, three of them lakes; in between, what the natural neighbours of a place say " +
      "(naturalWeights). The thicker a line, the larger the station's part.",
  ],
  relax: [
    "Relaxation",
    "Sites move to the centroids of their cells and areas are fitted again, round by round: " +
      "orange cells are eight times as large as blue ones, all the time.",
  ],
};

/** Examples that need a bundler, or no browser. */
const kFiles = {
  "react.jsx": "React",
  "bubble_chart.vue": "Vue",
  "bubble_chart.svelte": "Svelte",
  "observable_framework.md": "Observable Framework",
  "plot_mark.js": "Observable Plot",
  "leaflet.js": "Leaflet",
  "maplibre.js": "MapLibre",
  "deckgl.js": "deck.gl",
  "echarts.js": "ECharts",
  "chartjs.js": "Chart.js",
  "plotly.js": "Plotly",
  "vega_lite.js": "Vega-Lite",
  "threads.mjs": "threads in Node",
  "commonjs.cjs": "CommonJS",
  "cloudflare_worker.js": "Cloudflare Workers",
};
const kSource = "."; // as they are served

const kThumbnailTime = 1500; // ms until what moves in a card stands still

const element = (id) => document.getElementById(id);
const main = element("main");

/** @param {string} tag @param {Record<string, any>} properties @param {(Node | string)[]} inside */
function make(tag, properties, ...inside) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...inside);
  return made;
}

const run = async (name, container) => (await import(`./${name}.js`)).default(container);

function showCards() {
  const cards = Object.entries(kExamples).map(([name, [title, about]]) => {
    const picture = make("div", { className: "picture", inert: true });
    picture.setAttribute("aria-hidden", "true");
    const card = make(
      "a",
      { className: "card", href: `#${name}` },
      picture,
      make("h2", {}, title),
      make("p", {}, about),
    );
    return { name, card, picture };
  });
  const files = Object.entries(kFiles).flatMap(([file, title], k) => [
    k === 0 ? "" : ", ",
    make("a", { href: `${kSource}/${file}`, target: "_blank", rel: "noopener" }, title),
  ]);
  main.replaceChildren(
    make("div", { className: "cards" }, ...cards.map(({ card }) => card)),
    make("p", { className: "files" }, "For frameworks and servers: ", ...files, "."),
  );
  // Each card is the example itself, once it is seen.
  const pictures = new Map(cards.map(({ name, picture }) => [picture, name]));
  const watch = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      watch.unobserve(target);
      showCard(pictures.get(/** @type {HTMLDivElement} */ (target)), target);
    }
  });
  for (const picture of pictures.keys()) watch.observe(picture);
}

/** @param {string} name @param {Element} picture */
async function showCard(name, picture) {
  const { simulation } = await run(name, picture);
  picture.closest(".card").toggleAttribute("data-shown", true); // for tests
  setTimeout(() => simulation?.stop(), kThumbnailTime);
}

/** @param {string} name */
async function showExample(name) {
  const [title, about] = kExamples[name];
  document.title = `${title} · Apollonius diagram`;
  element("back").textContent = "← Examples";
  element("back").setAttribute("href", "./");
  element("title").textContent = title;
  element("about").textContent = about;
  const figure = make("figure", {});
  const code = make("code", {});
  const copy = make("button", { type: "button" }, "Copy");
  const text = make("pre", { tabIndex: 0 }, code);
  main.replaceChildren(figure, make("div", { className: "code" }, copy, text));
  copy.addEventListener("click", async () => {
    await navigator.clipboard.writeText(code.textContent);
    copy.textContent = "Copied";
  });
  const address = new URL(`./${name}.js`, import.meta.url);
  code.textContent = await (await fetch(address)).text();
  // For tests, and to play with in the console.
  Object.assign(window, { example: await run(name, figure) });
}

const chosen = location.hash.slice(1);
if (chosen in kExamples) await showExample(chosen);
else showCards();
addEventListener("hashchange", () => location.reload());
