// npm run picture: README's moving picture, docs/images/twins.webp: the figure "twins" while its
// ghost pointer goes round, from the figure's own drawing. It needs dist/ (npm run build).
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { figureModules } from "./site/posters.mjs";
import { root } from "./toolchain/folders.mjs";
import { SetUpError } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

const kFile = "docs/images/twins.webp";
const kMostBytes = 400_000;
const kScale = 1.5; // pixels a unit
const kTour = 9.9; // seconds, after which the pointer is where it was
const kEach = 0.08; // seconds a frame; those that are equal are one

/** The colours of the site on light paper, by the names of their variables. */
function lightColors() {
  const css = readFileSync(path.join(root, "web/theme.css"), "utf8");
  const light = css.slice(0, css.indexOf("@media"));
  return new Map(
    [...light.matchAll(/(--[\w-]+):\s*([^;]+);/g)].map(([, name, value]) => [name, value]),
  );
}

/** The frames as SVG, each with how long it is seen, in milliseconds. */
async function framesOf(name) {
  const { SvgPen, figures } = await figureModules();
  const figure = figures[name].default;
  const size = figure.size.wide;
  const colors = lightColors();
  const state = figure.start(size, false);
  const frames = [];
  for (let time = 0; time < kTour - kEach / 2; time += kEach) {
    const pen = new SvgPen(name, ...size);
    pen.rectangle(0, 0, ...size, "paper");
    figure.draw(pen, state);
    const [width, height] = size.map((units) => kScale * units);
    const svg = pen
      .toSvg()
      .replace("<svg", `<svg width="${width}" height="${height}"`)
      .replace(/var\((--[\w-]+)\)/g, (_, variable) => colors.get(variable));
    const last = frames.at(-1);
    if (last?.svg === svg) last.delay += 1000 * kEach;
    else frames.push({ svg, delay: 1000 * kEach });
    figure.tick(state, kEach, false);
  }
  return frames;
}

await main(async () => {
  const { default: sharp } = await import("sharp");
  const frames = await framesOf("twins");
  const images = frames.map(({ svg }) => Buffer.from(svg));
  const picture = await sharp(images, { join: { animated: true } })
    .webp({
      lossless: true,
      effort: 6,
      delay: frames.map(({ delay }) => Math.round(delay)),
      loop: 0,
    })
    .toBuffer();
  if (picture.length > kMostBytes)
    throw new SetUpError(`${kFile} would have ${picture.length} bytes, more than ${kMostBytes}`);
  writeFileSync(path.join(root, kFile), picture);
  console.log(`${kFile}: ${frames.length} frames, ${picture.length} bytes`);
});
