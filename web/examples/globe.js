// The world's cities on a globe that turns under the pointer. Cells are computed once, in degrees;
// a frame only projects them (d3-geo), all their edges as one path. The globe fills its container.
import { SphericalDiagram } from "apollonius-diagram/sphere";
import { geoEqualEarth, geoOrthographic, geoPath } from "d3-geo";

const radius = 6371.0088; // km, of the Earth: the unit of circles and distances
const reach = 330; // km, of the largest city's circle
const tolerance = 2; // km, of the edges: a pixel where the globe is largest
// Between points of the coast, in km, and how far a curve's chords may be from it, in pixels.
const fine = { apart: 0, precision: 0.3 };
const coarse = { apart: 60, precision: 1 }; // while it turns
const smallest = 0.4; // pixels, of a circle that is drawn
const step = 5; // degrees that an arrow key turns
const zooms = [0.7, 8];
const about =
  "The more people a city has, the wider its circle, and distances count from the circle’s edge: " +
  "that is the city’s head start.";

const day = { sea: "#e3ecf2", land: "#e8dfca", edge: "#5f6b76", city: "#31759866" };
const night = { sea: "#1a2530", land: "#36404a", edge: "#8795a2", city: "#6fb3de70" };
const red = { day: "#c0272d", night: "#ff8a7a" };

const data = async (name) => (await fetch(new URL(`../data/${name}.json`, import.meta.url))).json();
// The files are of a flat map, in km: back to degrees.
const map = geoEqualEarth().scale(6371).translate([0, 0]);
const lonLat = (x, y) => map.invert([x, -y]);

/** A place as a point of the unit sphere. */
function pointOf(lon, lat) {
  const [a, b] = [(lon * Math.PI) / 180, (lat * Math.PI) / 180];
  return [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
}

const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];

/** A ring x, y, steps to the next ones; without points that are less than `apart` from the last. */
function ringOf(steps, apart) {
  const ring = [];
  let [x, y, lastX, lastY] = [0, 0, Infinity, Infinity];
  for (let k = 0; k < steps.length; k += 2) {
    x += steps[k];
    y += steps[k + 1];
    if (Math.hypot(x - lastX, y - lastY) < apart) continue;
    [lastX, lastY] = [x, y];
    ring.push(lonLat(x, y));
  }
  return [...ring, ring[0]];
}

const landOf = (rings, apart) => ({
  type: "Polygon",
  coordinates: rings.map((steps) => ringOf(steps, apart)).filter(({ length }) => length > 3),
});

const add = (parent, tag, properties = {}) =>
  parent.appendChild(Object.assign(document.createElement(tag), properties));

export default async function globe(container) {
  const [{ cities: rows, fields }, { land }] = await Promise.all(["cities", "land"].map(data));
  const [name, x, y, people] = ["name", "x", "y", "population"].map((key) => fields.indexOf(key));
  const cities = rows.map((row) => {
    const place = lonLat(row[x], row[y]);
    const r = reach * Math.sqrt(row[people] / rows[0][people]);
    return { name: row[name], place, point: pointOf(place[0], place[1]), r };
  });
  const diagram = SphericalDiagram.from(
    cities,
    ({ place }) => place[0],
    ({ place }) => place[1],
    ({ r }) => r,
    { radius },
  );
  const cells = diagram.voronoi();
  const edges = cells.cellMesh({ tolerance });
  const coasts = new Map([fine, coarse].map((detail) => [detail, landOf(land, detail.apart)]));

  const box = add(container, "div", { className: "globe" });
  const canvas = add(box, "canvas"); // what turns
  const above = add(box, "canvas", { tabIndex: 0, ariaLabel: "Globe: arrow keys turn it" });
  above.setAttribute("role", "application");
  const answer = add(box, "output");
  add(box, "p", { textContent: about });
  const contexts = [canvas, above].map((each) => each.getContext("2d"));
  const projection = geoOrthographic().clipAngle(90).rotate([-15, -28]);
  const dark = matchMedia("(prefers-color-scheme: dark)");

  let zoom = 1;
  let pointer = null; // where it is on the canvas
  let isDragging = false;
  let detail = fine;
  let stillness = null; // the timer that ends the turning
  let isAsked = false; // for a frame
  let isOld = true; // the drawing of all but what is picked
  let picked = null; // { id, distance, place } of the nearest city

  /** Canvases as large as they are shown, the globe in the middle. */
  function resize() {
    const { clientWidth: width, clientHeight: height } = above;
    const [w, h] = [width, height].map((size) => Math.round(size * devicePixelRatio));
    for (const each of [canvas, above])
      if (each.width !== w || each.height !== h) {
        Object.assign(each, { width: w, height: h });
        isOld = true;
      }
    projection.translate([width / 2, height / 2]);
    projection.scale(zoom * Math.max(1, Math.min(width, height) / 2 - 8));
  }

  /** The nearest city of what the pointer is at; beside the globe, of its middle. */
  function pick() {
    const [x, y] = projection.translate();
    const isOn = pointer && Math.hypot(pointer[0] - x, pointer[1] - y) < projection.scale();
    const place = projection.invert(isOn ? pointer : [x, y]);
    picked = { ...diagram.nearest(place[0], place[1]), place };
    const km = Math.abs(Math.round(picked.distance)).toLocaleString("en");
    const where = picked.distance < 0 ? `${km} km inside its circle` : `${km} km away`;
    answer.textContent = `${cities[picked.id].name}: ${where}`;
  }

  /** Circles on a ball look like ellipses, which are narrow near its rim. */
  function circles(context, list) {
    const [[mx, my], scale] = [projection.translate(), projection.scale()];
    const [lon, lat] = projection.rotate().map((angle) => -angle);
    const [ahead, east, north] = [pointOf(lon, lat), pointOf(lon + 90, 0), pointOf(lon, lat + 90)];
    context.beginPath();
    for (const { point, r } of list) {
      const size = r / radius;
      const slope = dot(point, ahead);
      if (slope < Math.sin(size) || size * scale < smallest) continue; // not all on this side
      const [x, y] = [scale * dot(point, east), -scale * dot(point, north)];
      const [half, inwards, angle] = [scale * Math.sin(size), Math.cos(size), Math.atan2(y, x)];
      const [cx, cy, width] = [mx + x * inwards, my + y * inwards, half * slope];
      context.moveTo(cx + width * Math.cos(angle), cy + width * Math.sin(angle));
      context.ellipse(cx, cy, width, half, angle, 0, 2 * Math.PI);
    }
    context.fill();
  }

  /** Starts with an empty canvas; returns what draws GeoJSON on it. */
  function pen(context, lineWidth) {
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, above.clientWidth, above.clientHeight);
    context.lineWidth = lineWidth;
    const path = geoPath(projection, context);
    return (object, fill, stroke = "") => {
      context.beginPath();
      path(object);
      if (fill) Object.assign(context, { fillStyle: fill }).fill();
      if (stroke) Object.assign(context, { strokeStyle: stroke }).stroke();
    };
  }

  function drawGlobe(context) {
    const { sea, land, edge, city } = dark.matches ? night : day;
    projection.precision(detail.precision);
    const shape = pen(context, Math.min(0.7, projection.scale() / 400));
    const [x, y] = projection.translate();
    context.beginPath();
    context.arc(x, y, projection.scale(), 0, 2 * Math.PI); // { type: "Sphere" } has corners
    Object.assign(context, { fillStyle: sea }).fill();
    shape(coasts.get(detail), land);
    shape(edges, "", edge);
    context.fillStyle = city;
    circles(context, cities);
  }

  function drawPicked(context) {
    const stroke = dark.matches ? red.night : red.day;
    const { id, place } = picked;
    const shape = pen(context, 1.5);
    shape(cells.cellGeometry(id, { winding: "clockwise" }), `${stroke}40`, stroke);
    shape({ type: "LineString", coordinates: [place, cities[id].place] }, "", stroke);
    context.fillStyle = stroke;
    circles(context, [cities[id]]);
  }

  function draw() {
    isAsked = false;
    resize();
    if (isOld) drawGlobe(contexts[0]);
    isOld = false;
    pick();
    drawPicked(contexts[1]);
  }
  function redraw({ all = true } = {}) {
    isOld ||= all;
    if (!isAsked) requestAnimationFrame(draw);
    isAsked = true;
  }

  /** With less detail until it has stood still for a moment. */
  function turn(east, north) {
    const [lon, lat] = projection.rotate();
    projection.rotate([lon - east, Math.max(-90, Math.min(90, lat - north))]);
    detail = coarse;
    clearTimeout(stillness);
    stillness = setTimeout(() => {
      detail = fine;
      redraw();
    }, 150);
    redraw();
  }
  function zoomBy(factor) {
    zoom = Math.max(zooms[0], Math.min(zooms[1], zoom * factor));
    redraw();
  }

  above.onpointerdown = (event) => {
    if (!event.isPrimary) return;
    above.setPointerCapture(event.pointerId);
    pointer = [event.offsetX, event.offsetY];
    isDragging = true;
    redraw({ all: false });
  };
  above.onpointermove = ({ offsetX, offsetY, isPrimary }) => {
    if (!isPrimary) return;
    const [x, y] = pointer ?? [offsetX, offsetY];
    pointer = [offsetX, offsetY];
    const degrees = 180 / Math.PI / projection.scale();
    if (isDragging) turn((x - offsetX) * degrees, (offsetY - y) * degrees);
    redraw({ all: isDragging });
  };
  above.onpointerup = above.onpointercancel = () => (isDragging = false);
  above.onpointerleave = ({ pointerType }) => {
    if (pointerType !== "mouse") return; // a finger that is lifted has asked
    pointer = null;
    redraw({ all: false });
  };
  above.onwheel = (event) => {
    // A page that scrolls keeps the wheel; with Ctrl, or two fingers on a trackpad, it zooms.
    if (!event.ctrlKey && document.documentElement.scrollHeight > innerHeight) return;
    event.preventDefault();
    zoomBy(2 ** (-event.deltaY / (event.ctrlKey ? 100 : 400)));
  };
  const keys = {
    ArrowLeft: () => turn(-step, 0),
    ArrowRight: () => turn(step, 0),
    ArrowUp: () => turn(0, step),
    ArrowDown: () => turn(0, -step),
    "+": () => zoomBy(1.25),
    "-": () => zoomBy(0.8),
  };
  above.onkeydown = (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    pointer = null;
    keys[event.key]();
  };
  dark.onchange = () => redraw();
  draw();
  new ResizeObserver(draw).observe(above); // at once, as a new size empties it
  return { diagram, cities, projection, canvas, above, answer, turn, picked: () => picked };
}
