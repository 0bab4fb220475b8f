// Puts the page together.
import { whenLoaded } from "../shared/package.js";
import { whenThemeChanges } from "../shared/theme.js";
import { App } from "./app.js";
import { messageOf } from "../shared/errors.js";
import { Motion } from "./motion/motion.js";
import { letWander } from "./motion/wanderer.js";
import { makeNavigation } from "./navigation.js";
import { parts } from "./parts.js";
import { showRevivals } from "./revivals.js";
import { prepareToBuild } from "./sets/building.js";
import { fetchCities } from "./sets/cities.js";
import { whenShown } from "./shown.js";
import { listenToPointer } from "./tools/gestures.js";
import { listenToKeyboard } from "./tools/keyboard.js";
import { makeAbout } from "./ui/about.js";
import { makeAnnouncer } from "./ui/announcer.js";
import { makeCodeDialog } from "./ui/code.js";
import { element } from "./ui/elements.js";
import { makeHelp } from "./ui/help.js";
import { makeInvitation } from "./ui/invitation.js";
import { makeInspector } from "./ui/inspector.js";
import { notify } from "./ui/notice.js";
import { makeSetsMenu } from "./ui/sets_menu.js";
import { makeShareMenu } from "./ui/share.js";
import { makeSheet } from "./ui/sheet.js";
import { makeShowMenu } from "./ui/show_menu.js";
import { makeStatus } from "./ui/status.js";
import { makeTag } from "./ui/tag.js";
import { makeToolbar } from "./ui/toolbar.js";

/** Keeps the canvases as large as the window, on any screen. */
function followWindow(app: App) {
  const resize = () => app.painter.resize(innerWidth, innerHeight, devicePixelRatio || 1);
  const watchDensity = () => {
    // Another screen has another density: no event tells but the end of this one.
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      "change",
      () => {
        resize();
        watchDensity();
      },
      { once: true },
    );
  };
  resize();
  watchDensity();
  addEventListener("resize", resize);
  // The style sheet puts what is narrow below the introduction.
  const intro = element("intro");
  new ResizeObserver(() => {
    const { bottom } = intro.getBoundingClientRect();
    document.documentElement.style.setProperty("--intro-end", `${bottom}px`);
  }).observe(intro);
  whenThemeChanges(() => app.painter.readTheme());
}

const kIdle = 1500; // ms after the start
const kFree = 4; // pixels below the introduction that need no margin

/**
 * Pixels that the bars cover: all that lies along the upper or the lower border, or the open sheet
 * of a phone that is held sideways.
 */
function insets() {
  const top = element("intro").getBoundingClientRect().bottom - kFree;
  const sheet = element("sheet");
  const { right, width } = sheet.getBoundingClientRect();
  const isBeside = sheet.classList.contains("open") && width > 0 && width < innerWidth / 2;
  const bottom = (["tools", "sheet", "status", "library"] as const)
    .filter((id) => !(isBeside && sheet.contains(element(id))))
    .map((id) => element(id).getBoundingClientRect())
    .reduce((least, box) => (box.height > 0 ? Math.min(least, box.top) : least), innerHeight);
  return { left: isBeside ? right : 0, top, right: 0, bottom: innerHeight - bottom };
}

/** Makes everything and shows what the address says. */
export async function start() {
  await whenLoaded(["shapes"]);
  const canvases = {
    map: element("map"),
    lines: element("lines"),
    spare: element("spare"),
    circles: element("circles"),
    overlay: element("overlay"),
  };
  const app = new App(canvases);
  app.camera.insets = insets;
  const motion = new Motion(app);
  followWindow(app);
  const gestures = listenToPointer(canvases.overlay, app);
  listenToKeyboard(canvases.overlay, app, gestures);
  const navigation = makeNavigation(app);
  showRevivals(app);
  makeToolbar(app);
  makeHelp();
  makeTag(app);
  makeInspector(app);
  makeAnnouncer(app);
  makeStatus(app);
  makeSetsMenu(app, navigation);
  makeShowMenu(app, motion);
  makeShareMenu(app, navigation.write);
  makeCodeDialog(app);
  makeSheet(app);
  makeInvitation(app);
  makeAbout(app);

  const isPlain = location.hash === "";
  try {
    await navigation.open();
  } catch (error) {
    notify(`The set of this link could not be shown: ${messageOf(error)}`);
    history.replaceState(null, "", "#");
    await navigation.open();
  }
  whenShown(app).then(() => document.getElementById("poster")?.remove());
  if (isPlain) letWander(app);

  // A handle for tests and the curious; not an interface: it may change at any time.
  const handle = { navigation, motion, parts, whenShown: () => whenShown(app) };
  Object.assign(window, { app: Object.assign(app, { ...handle, whenFetched: fetchAhead() }) });
}

/**
 * Fetches, once the page is at rest, what it may need later, so that it then needs no network. A
 * failure is reported when the thing is asked for.
 */
async function fetchAhead() {
  await new Promise((resolve) => setTimeout(resolve, kIdle));
  await Promise.allSettled([fetchCities(), prepareToBuild()]);
}
