// Keys, while the canvas has the focus. With a selected circle they act on it, without one on the
// view.

const kStep = 4; // pixels an arrow key moves a circle; with Shift ten times as far
const kPan = 60;
const kGrow = 1.05;

const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * @param {HTMLElement} element @param {import("./app.js").App} app @param {{ fit(): void }} actions
 */
export function listenToKeyboard(element, app, actions) {
  /** Where keys insert and look for a site: under the pointer, else in the middle of the window. */
  const place = () => app.pointer ?? { x: app.view.width / 2, y: app.view.height / 2 };

  function arrow([dx, dy], event) {
    if (app.selected < 0) {
      app.pan(-dx * kPan, -dy * kPan);
      return;
    }
    const step = (event.shiftKey ? 10 : 1) * (kStep / app.view.scale);
    const { x, y } = app.scene.site(app.selected);
    app.move(app.selected, x + dx * step, y - dy * step);
  }

  function grow(factor) {
    if (app.selected < 0) {
      app.zoom(factor > 1 ? 1.25 : 0.8);
      return;
    }
    const { r } = app.scene.site(app.selected);
    app.resize(app.selected, Math.max(r, 1 / app.view.scale) * factor);
  }

  /** Selects the next neighbour of the selected site, in the order around it. */
  let around = { of: -1, step: 0 };
  function walk(direction) {
    if (app.selected < 0) return;
    if (
      around.of < 0 ||
      !app.diagram.has(around.of) ||
      !app.diagram.neighbors(around.of).includes(app.selected)
    ) {
      around = { of: app.selected, step: -1 };
    }
    const ring = app.diagram.neighbors(around.of);
    if (ring.length === 0) return;
    around.step = (around.step + direction + ring.length) % ring.length;
    app.select(ring[around.step]);
  }

  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { key } = event;
    if (key in kArrows) arrow(kArrows[key], event);
    else if (key === "+" || key === "=") grow(kGrow);
    else if (key === "-" || key === "_") grow(1 / kGrow);
    else if ((key === "Delete" || key === "Backspace") && app.selected >= 0)
      app.remove(app.selected);
    else if (key === "Escape") app.select(-1);
    else if (key === "Enter") selectNearest();
    else if (key === "Insert" || key === "i") app.insertAt(place().x, place().y);
    else if (key === "n") walk(1);
    else if (key === "p") walk(-1);
    else if (key === "0" || key === "Home") actions.fit();
    else return;
    event.preventDefault();
  });

  function selectNearest() {
    const { x, y } = place();
    const id = app.diagram.find(app.view.toWorldX(x), app.view.toWorldY(y));
    if (id >= 0) app.select(id);
    around = { of: -1, step: 0 };
  }
}
