// Where circles come to rest after a motion: at numbers that are as long as the picture needs, so
// that hundreds of them fit into a link. Digits that nobody sees would make it three times as long.
import type { Diagram } from "apollonius-diagram";
import { roundedTo } from "../../shared/rounding.js";
import type { App } from "../app.js";
import type { OpenChange } from "../model/model.js";

const kPixels = 1 / 32; // between two numbers, at most: a circle moves by half of it
const kTries = 3; // each with one more digit

/** Rounds the coordinates that have changed, if no circle becomes hidden or visible by that. */
export function roundMoved(app: App, change: OpenChange) {
  const { before, after } = change;
  const hidden = hiddenOf(app.diagram);
  let digits = digitsOf(app);
  for (let k = 0; k < kTries; k++, digits++) {
    change.to(
      after.map((value, k) =>
        k % 3 === 2 || value === before[k] ? value : roundedTo(value, digits),
      ),
    );
    if (hiddenOf(app.diagram) === hidden) return;
  }
  change.to(after);
}

/** Decimal places that show no difference now, nor when all circles are shown. */
function digitsOf({ sites, view, camera }: App) {
  const fitted = view.copy();
  const bounds = sites.bounds();
  if (bounds) fitted.fit(bounds, camera.insets());
  return Math.max(view.digits(kPixels), fitted.digits(kPixels));
}

/** Which circles are hidden, as a text. */
const hiddenOf = (diagram: Diagram) =>
  diagram
    .ids()
    .filter((id) => diagram.isHidden(id))
    .join();
