// Starts the page.
import { load } from "apollonius-diagram";
import { App } from "./app.js";
import { loadCities } from "./cities.js";
import { listenToKeyboard } from "./keyboard.js";
import { Panel } from "./panel.js";
import { listenToPointer } from "./pointer.js";
import { randomCircles } from "./random_sets.js";

const kRandomSize = { width: 1600, height: 1000 }; // of random sets, in units
const kFirstView = [-1100, 3900, 4100, 7200]; // Europe: large enough that one sees the curves
const kNarrow = 760; // pixels, as in style.css: the panel is on top instead of at the left

const element = (id) => document.getElementById(id);

async function start() {
  const citiesLoading = loadCities();
  citiesLoading.catch(() => {}); // awaited below
  await load();
  const canvas = element("overlay");
  const app = new App({ map: element("map"), base: element("base"), overlay: canvas });
  let seed = 1;
  let bounds = null; // of the set that was loaded: what "fit" shows while it is there

  const resize = () =>
    app.painter.resize(window.innerWidth, window.innerHeight, window.devicePixelRatio || 1);
  const watchDensity = () => {
    // Another screen has another density: no event tells but the end of this one.
    matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener(
      "change",
      () => {
        resize();
        watchDensity();
      },
      { once: true },
    );
  };
  const insets = () =>
    window.innerWidth <= kNarrow
      ? { left: 0, top: 150, right: 0, bottom: 0 }
      : { left: 280, top: 0, right: 0, bottom: 0 };

  const actions = {
    async cities(firstView = null) {
      const cities = await citiesLoading;
      app.painter.map = cities.map;
      panel.unit = "km";
      panel.showsMap(true);
      bounds = cities.bounds;
      app.replaceAll(cities.xyr, cities.labels);
      if (firstView) app.fit(firstView, insets(), 0);
      else actions.fit();
    },
    random(count, hiddenShare) {
      app.painter.map = null;
      panel.unit = "";
      panel.showsMap(false);
      bounds = null;
      app.replaceAll(randomCircles({ count, hiddenShare, seed: seed++, ...kRandomSize }));
      app.fit(undefined, insets());
    },
    clear() {
      app.replaceAll(new Float64Array(0), []);
    },
    fit() {
      // The world may lie under the panel: there is only sea.
      if (bounds && window.innerWidth > kNarrow) app.fit(bounds);
      else app.fit(bounds ?? app.scene.bounds(), insets());
    },
  };
  const panel = new Panel(app, actions);
  panel.fold(window.innerWidth <= kNarrow);

  resize();
  watchDensity();
  window.addEventListener("resize", resize);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () =>
    app.painter.readTheme(),
  );
  listenToPointer(canvas, app);
  listenToKeyboard(canvas, app, actions);
  await actions.cities(kFirstView);

  // A handle for tests and the curious; not an interface: it may change at any time.
  Object.assign(window, { app });
}

start().catch((error) => {
  console.error(error);
  const failure = element("failure");
  failure.textContent = `The diagram could not be started: ${error.message}`;
  failure.hidden = false;
});
