// A treemap of four levels: the classes of a program, packages within packages. Branches have their
// colours, levels the width of their lines. The pointer makes a class grow: `previous` keeps all
// others where they are, and each frame takes two or three steps.
import { treemap } from "apollonius-diagram/treemap";
import { hierarchy } from "d3-hierarchy";

const width = 920,
  height = 480,
  growth = 8;
const ratio = Math.min(3, globalThis.devicePixelRatio ?? 1);
const hues = [210, 28, 150, 330, 48, 268, 185, 4, 100, 235];
const widths = [0, 5, 2.5, 1.2, 0.6]; // by level

/** Between an ellipse and a rectangle. */
const outline = Array.from({ length: 240 }, (_, k) => {
  const [c, s] = [Math.cos((k * Math.PI) / 120), Math.sin((k * Math.PI) / 120)];
  return [
    (width / 2) * (1 + 0.99 * Math.sign(c) * Math.abs(c) ** 0.4),
    (height / 2) * (1 + 0.98 * Math.sign(s) * Math.abs(s) ** 0.4),
  ];
});

function colour(leaf) {
  const [root, branch, group] = leaf.ancestors().reverse();
  const hue = hues[root.children.indexOf(branch) % hues.length];
  const shade = branch.children.indexOf(group) % 5;
  return `hsl(${hue} ${58 - 4 * shade}% ${62 + 5 * shade}%)`;
}

export default async function nested(container) {
  const data = await (await fetch(new URL("../data/flare.json", import.meta.url))).json();
  const sizes = new Map();
  const tree = hierarchy(data)
    .sum(({ size = 0 }) => size)
    .sort((a, b) => b.value - a.value);
  const layout = treemap().shape(outline);
  const root = await layout.async(tree);
  for (const { data } of root.leaves()) sizes.set(data, data.size);
  const colours = new Map(root.leaves().map((leaf) => [leaf, colour(leaf)]));

  const canvas = container.appendChild(
    Object.assign(document.createElement("canvas"), {
      width: ratio * width,
      height: ratio * height,
    }),
  );
  canvas.style.width = "100%";
  const said = container.appendChild(document.createElement("output"));
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);

  function draw() {
    context.clearRect(0, 0, width, height);
    context.lineJoin = "round";
    context.strokeStyle = "#fff";
    const path = (node) => {
      context.beginPath();
      node.render(context);
    };
    for (const leaf of root.leaves()) {
      path(leaf);
      context.fillStyle = colours.get(leaf);
      context.fill();
    }
    for (const node of root.descendants().reverse()) {
      if (node === root) continue;
      path(node);
      context.lineWidth = widths[node.depth];
      context.stroke();
    }
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = "#0008";
    for (const { area, centroid, data } of root.leaves()) {
      const size = Math.min(18, (1.3 * Math.sqrt(area)) / data.name.length);
      if (size < 6) continue;
      context.font = `${size}px system-ui, sans-serif`;
      context.fillText(data.name, ...centroid);
    }
  }

  let pointed = null;
  let isMoving = false;
  /** The sizes of leaves on their way to what they are to be. */
  function frame() {
    isMoving = false;
    root.sum((data) => {
      if (data.size === undefined) return 0;
      const wanted = data === pointed?.data ? growth * data.size : data.size;
      const size = sizes.get(data) * (wanted / sizes.get(data)) ** 0.2;
      isMoving ||= Math.abs(size / wanted - 1) > 0.01;
      sizes.set(data, size);
      return size;
    });
    layout(root, { previous: root });
    draw();
    if (isMoving) requestAnimationFrame(frame);
  }
  const path2d = (node) => new Path2D(node.render());
  function point(event) {
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.x) / box.width) * width;
    const y = ((event.clientY - box.y) / box.height) * height;
    const isIn = (node) => context.isPointInPath(path2d(node), ratio * x, ratio * y);
    let node = root;
    while (node.children !== undefined) {
      const next = node.children.find(isIn);
      if (next === undefined) return;
      node = next;
    }
    if (node === pointed) return;
    pointed = node;
    const names = node.ancestors().reverse();
    said.textContent = names.map(({ data }) => data.name).join(" › ");
    if (!isMoving) requestAnimationFrame(frame);
    isMoving = true;
  }
  canvas.addEventListener("pointerdown", point);
  canvas.addEventListener("pointermove", point);
  draw();
  return { root, layout, draw, sizes, simulation: { stop() {} } };
}
