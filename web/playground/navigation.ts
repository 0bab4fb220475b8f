// Keeps the page's address and what is shown together, in both directions.
import type { App } from "./app.js";
import { whenever } from "./model/signals.js";
import type { Sites } from "./model/sites.js";
import { isLayer } from "./picture/picture.js";
import { addressOf, type Kept, keptOf, type Looked, sitesOf, stateOf } from "./sets/address.js";
import type { Params } from "./sets/presets.js";
import { sayWhatFailed } from "./ui/notice.js";
import { withProgress } from "./ui/progress.js";

const kPause = 400; // ms at least from one writing to the next
const kMargin = 28; // pixels around a set

/** Sets lie across a tall window the other way. */
const shape = (): Record<string, string> => (innerHeight > innerWidth ? { tall: "1" } : {});

export function makeNavigation(app: App) {
  const usual = { ...app.painter.layers };
  let writing = 0;
  let written = -kPause;
  let isComingBack = false;

  /** Says what the address holds. */
  function write() {
    clearTimeout(writing);
    writing = 0;
    written = performance.now();
    const address = addressOf(app, usual);
    history.replaceState(keptOf(app.sites, address.isWhole), "", address.hash);
    return address;
  }

  /** Browsers allow a few hundred times a minute. */
  const writeLater = () => {
    writing ||= setTimeout(write, Math.max(0, written + kPause - performance.now()));
  };

  // An edit is written at once, unless they come fast: whoever leaves then loses nothing.
  let edited = -kPause;
  const writeEdit = () => {
    if (performance.now() - edited < kPause) return;
    edited = performance.now();
    write();
  };
  whenever(() => app.model.edits, writeEdit);
  whenever(() => [app.camera.looks, app.painter.layers, app.pointer.questions], writeLater);
  app.model.on("change", ({ isSet }) => {
    if (isSet) {
      if (!isComingBack) {
        history.pushState(null, "", location.href);
        write();
      }
      document.title = `${app.sites.info.title} · Apollonius diagram`; // of the entry that is new
    }
    if (!app.model.open) writeLater(); // else when it is done
  });
  addEventListener("beforeunload", () => writing && write());
  addEventListener("popstate", () => {
    clearTimeout(writing); // it was about the entry that has been left
    writing = 0;
    open().catch(sayWhatFailed("This could not be shown"));
  });

  /** Shows what the address says. It begins anew: Undo leads to no other entry of the history. */
  async function open() {
    const state = stateOf(location.hash);
    if (location.hash === "") state.params = shape();
    const kept: Kept | null = history.state;
    const sites = await withProgress((watch) => sitesOf(state, kept, watch));
    isComingBack = true;
    try {
      app.model.restart(sites);
    } finally {
      isComingBack = false;
    }
    for (const [name, isShown] of Object.entries({ ...usual, ...state.shown }))
      if (isLayer(usual, name)) app.setLayer(name, isShown);
    if (state.view) look(state.view);
    else app.camera.fit();
  }

  /** Shows this middle and width, in units. */
  function look([x, y, width]: Looked) {
    app.view.scale = app.view.width / width;
    app.view.originX = app.view.width / 2 - x * app.view.scale;
    app.view.originY = app.view.height / 2 + y * app.view.scale;
    app.camera.viewChanged();
  }

  return {
    open,
    write,
    /** Shows another set. */
    show(sites: Sites) {
      write();
      app.model.replace(sites);
      app.camera.fit(undefined, kMargin);
    },
    /** Shows another set by its name. */
    async load(key: string, params: Params = {}) {
      try {
        const state = { ...stateOf(""), key, params: { ...shape(), ...params } };
        this.show(await withProgress((watch) => sitesOf(state, null, watch)));
      } catch (error) {
        sayWhatFailed("This set could not be loaded")(error);
      }
    },
  };
}
